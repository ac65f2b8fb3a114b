use std::f64::consts::TAU;

use crate::emit::Real;
use crate::emit::functions::facets::Facets;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Reflectance of cloth that shines where it is seen edgewise: fibres whose normals are spread as
    /// `(2 + 1 / a) / (2 pi) sin^(1 / a)` of the half vector's angle, over `4 (n·l + n·v - (n·l) (n·v))`. Draw directions by
    /// `lambert_sample`. Reciprocal; at grazing angles a narrow one reflects more than all light (1.43 for a roughness of 0.05, 0.77
    /// for 0.3).
    ///
    /// The distribution is Estevez and Kulla's, the denominator Neubelt and Pettineo's, as in MaterialX's
    /// `sheen_bsdf` (`conty_kulla`) and glTF's sheen. The power of the sine comes from `log1p` of the squared
    /// cotangent, so that it stays accurate where the sine is nearly 1. A roughness below 10^-3 counts as that.
    sheen_brdf in brdf,
    source "Estevez and Kulla 2017, Production Friendly Microfacet Sheen BRDF; Neubelt and Pettineo 2013, Crafting a Next-Gen Material Pipeline for The Order: 1886",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Roughness of the cloth: less lets less light through between upright fibres.
        roughness: scalar = 0.3, in UNIT;
    }
    outputs {
        /// The reflectance, per steradian.
        value: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        Outputs { value: facets.where_above(value(&facets, i.roughness)) }
    }
}

/// The reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn value<R: Real>(facets: &Facets<R>, roughness: R) -> R {
    let one = roughness.same(1.0);
    let exponent = one / roughness.clamp_to(roughness.same(1e-3), one);
    // ln sin^2 = -ln(1 + cot^2); the cotangent of 0 is infinite, and the sine's power 0.
    let cotangent_squared = one / facets.slope_squared();
    let sine_power = (exponent * cotangent_squared.log1p() * -0.5).exp();
    let (light, viewer) = (facets.cosine_in, facets.cosine_out);
    let open = light + viewer * (one - light);
    (exponent + 2.0) * (0.25 / TAU) * sine_power / open
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_there_is_none_and_edgewise_it_shines() {
        assert_eq!(number!(normal = UP, direction = UP, ray = DOWN => value), 0.0);
        let at = |x: f32, z: f32, roughness: f32| {
            f64::from(
                number!(normal = UP, direction = [x, 0.0, z], ray = [x, 0.0, -z], roughness = roughness => value),
            )
        };
        // The half vector is the normal there, too.
        assert_eq!(at(0.8, 0.6, 0.5), 0.0);
        let value = number!(normal = UP, direction = [0.8, 0.0, 0.6], ray = [-0.8, 0.0, -0.6], roughness = 0.5 => value);
        let expected = (2.0 + 2.0) / std::f64::consts::TAU * 0.64 / (4.0 * (1.2 - 0.36));
        crate::nodes::harness::assert_close(&[value], &[expected], 1e-6, 0.0);
    }
}
