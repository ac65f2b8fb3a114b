use crate::emit::functions::conventions::not_negative;
use crate::emit::functions::frames::Frame;
use crate::emit::{Mask, Real};
use crate::nodes::brdf::ggx_brdf::Ggx;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `ggx_sample`: the distribution over `2 (n·v + |v|')`, `|v|'` being the length of
    /// the viewer's direction scaled by the roughness.
    ggx_density in brdf,
    source "Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps; Heitz 2018",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness alpha along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness alpha across it.
        roughness_v: scalar = 0.2, in UNIT;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let frame = Frame::along(i.normal, i.tangent);
        Outputs { density: density(&Ggx::of(&frame, i.direction, i.ray, i.roughness_u, i.roughness_v)) }
    }
}

/// The density of the light's direction; 0 where the half vector or the viewer is below.
#[inline(always)]
pub fn density<R: Real>(ggx: &Ggx<R>) -> R {
    let density = ggx.density();
    ggx.upright().select(not_negative(density), density.same(0.0))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_peak_is_known() {
        let density = number!(normal = [0.0, 0.0, 1.0], direction = [0.0, 0.0, 1.0], ray = [0.0, 0.0, -1.0], roughness_u = 0.1, roughness_v = 0.5 => density);
        crate::nodes::harness::assert_close(
            &[density],
            &[1.0 / (4.0 * std::f64::consts::PI * 0.05)],
            1e-6,
            0.0,
        );
    }
}
