use std::f64::consts::TAU;

use crate::emit::Real;
use crate::emit::functions::conventions::not_negative;
use crate::emit::functions::facets::Facets;
use crate::nodes::brdf::phong_brdf::lobe;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `phong_sample`: `(exponent + 1) / (2 pi) c^exponent`, c being the cosine
    /// from the mirrored ray.
    phong_density in brdf,
    source "Lafortune and Willems 1994, Using the Modified Phong Reflectance Model for Physically Based Rendering",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// How narrow the lobe is.
        exponent: scalar = 20.0, in 0.0..=1e8, soft 1.0..=1000.0;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| Outputs { density: density(&Facets::of(i.normal, i.direction, i.ray), i.exponent) }
}

/// The density of the direction of `facets`.
#[inline(always)]
pub fn density<R: Real>(facets: &Facets<R>, exponent: R) -> R {
    not_negative(lobe(facets, exponent, 0) * ((exponent + 1.0) * (1.0 / TAU)))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_peak_is_known() {
        let density = number!(normal = [0.0, 0.0, 1.0], direction = [0.0, 0.0, 1.0], ray = [0.0, 0.0, -1.0], exponent = 9.0 => density);
        crate::nodes::harness::assert_close(&[density], &[10.0 / std::f64::consts::TAU], 1e-6, 0.0);
    }
}
