use crate::emit::functions::facets::lit;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::ggx_brdf::Ggx;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::fresnel::fresnel_schlick::schlick_color;
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on small mirrors spread as those of ellipsoids: `light (n·l)` times `ggx_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    ggx in shading,
    source "Walter and others 2007; see `ggx_brdf`",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Colour of the light that arrives.
        light: color = node("light_color"), in INTENSITY, when lit(i.normal, i.direction, i.ray);
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness alpha along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness alpha across it.
        roughness_v: scalar = 0.2, in UNIT;
        /// Reflectance head on.
        f0: color = [0.04, 0.04, 0.04, 1.0], in UNIT;
        /// Reflectance at grazing angles.
        f90: color = WHITE, in UNIT;
    }
    outputs {
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let frame = Frame::along(i.normal, i.tangent);
        let ggx = Ggx::of(&frame, i.direction, i.ray, i.roughness_u, i.roughness_v);
        let fresnel = schlick_color(i.f0, i.f90, ggx.cosine_half());
        let factor = ggx.specular() * i.normal.dot(i.direction);
        Outputs { color: reflected(lit(i.normal, i.direction, i.ray), fresnel, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_fresnels_share_of_the_peak() {
        let shaded = number!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4], roughness_u = 0.5, roughness_v = 0.5 => color);
        crate::nodes::harness::assert_close(&[shaded], &[0.04 / std::f64::consts::PI], 1e-6, 0.0);
    }
}
