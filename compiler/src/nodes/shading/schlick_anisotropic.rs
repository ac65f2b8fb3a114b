use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::{grey, reflected};
use crate::nodes::brdf::schlick_anisotropic_brdf::factor;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::fresnel::fresnel_schlick::schlick_color;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on a brushed surface, cheaply: `light (n·l)` times `schlick_anisotropic_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    schlick_anisotropic in shading,
    source "Schlick 1994; see `schlick_anisotropic_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Direction along the surface that `isotropy` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness r: 0 a mirror, 1 diffuse.
        roughness: scalar = 0.1, in UNIT;
        /// Isotropy p: 1 the same all round, less for brushed surfaces.
        isotropy: scalar = 1.0, in UNIT;
        /// Reflectance head on.
        f0: color = [0.9, 0.9, 0.9, 1.0], in UNIT;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let fresnel = schlick_color(i.f0, grey(e.real(1.0)), facets.cosine_half());
        let factor = factor(&facets, &frame, i.roughness, i.isotropy) * facets.cosine_in;
        Outputs { color: reflected(facets.above(), fresnel, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_the_reflectance_over_the_roughness() {
        let peak = 0.9 / 0.1 / (4.0 * std::f64::consts::PI);
        let shaded = numbers!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4] => color);
        crate::nodes::harness::assert_close(&shaded, &[peak, peak, peak, 1.0], 1e-6, 0.0);
    }
}
