use crate::emit::Real;
use crate::emit::functions::distributions::roughness;
use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::mirrored_density;
use crate::nodes::brdf::ward_brdf::gaussian;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `ward_sample`:
    /// `exp(-tan^2) / (4 pi a b (h·v) (h·n)^3)`, the tangent scaled by the roughness.
    ward_density in brdf,
    source "Walter 2005, Notes on the Ward BRDF",
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
        /// Roughness along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness across it.
        roughness_v: scalar = 0.2, in UNIT;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let density = density(&facets, &frame, roughness(i.roughness_u), roughness(i.roughness_v));
        Outputs { density }
    }
}

/// The density of the direction of `facets`.
#[inline(always)]
pub fn density<R: Real>(facets: &Facets<R>, frame: &Frame<R>, u: R, v: R) -> R {
    let cosine = facets.height().absolute() / facets.squared().sqrt();
    // Four times Ward's Gaussian over cos^3 is the density of half vectors.
    let of_half = gaussian(facets, frame, u, v) * 4.0 / cosine / cosine / cosine;
    mirrored_density(facets, of_half)
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
