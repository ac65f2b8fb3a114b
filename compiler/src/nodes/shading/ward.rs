use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::ward_brdf::value;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Ward's highlight for one light sample, along brushed surfaces: `color light (n·l)` times `ward_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    ward in shading,
    source "Ward 1992; see `ward_brdf`; mental ray base shaders, mib_illum_ward",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Colour of the surface.
        color: color = WHITE, in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness across it.
        roughness_v: scalar = 0.2, in UNIT;
        /// Which form.
        form: choice = 2, of ["ward_1992", "duer_2006", "bounded_2010", "mental_ray"];
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let factor = value(&facets, &frame, i.roughness_u, i.roughness_v, i.form) * facets.cosine_in;
        Outputs { color: reflected(facets.above(), i.color, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_the_peak() {
        let peak = 1.0 / (4.0 * std::f64::consts::PI * 0.05 * 0.4);
        let shaded = numbers!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4], roughness_u = 0.05, roughness_v = 0.4 => color);
        crate::nodes::harness::assert_close(&shaded, &[peak, peak, peak, 1.0], 1e-6, 0.0);
    }
}
