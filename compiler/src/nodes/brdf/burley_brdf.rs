use std::f64::consts::PI;

use crate::emit::functions::facets::Facets;
use crate::emit::functions::reflected::shown;
use crate::emit::{Color, Real};
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, WHITE, state};
use crate::state::Field;

node! {
    /// Reflectance of a diffuse surface as measured ones are near grazing: `color / pi` times
    /// `(1 + (f - 1) (1 - n·l)^5) (1 + (f - 1) (1 - n·v)^5)` with `f = 1/2 + 2 roughness (h·l)^2`. A smooth one is
    /// darker along its edge than Lambert's, a rough one brighter. Draw directions by `lambert_sample`. Reciprocal.
    ///
    /// It was fitted by eye, and does not keep energy: at grazing angles a rough one reflects more than all light
    /// (1.52 of its colour at 89 degrees for a roughness of 1, 1.02 for a half); see the tests. `2 (h·l)^2` is half of
    /// `|l + v|^2`, so no half vector is made. MaterialX and OSL call it `burley_diffuse_bsdf`, with the same
    /// roughness; it is the diffuse part of Disney's material, without the part for flat scattering.
    burley_brdf in brdf,
    source "Burley 2012, Physically Based Shading at Disney, section 5.3",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// How rough the surface is.
        roughness: scalar = 0.5, in UNIT;
        /// Share of light that is reflected head on.
        color: color = WHITE, in UNIT;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        Outputs { value: shown(facets.above(), value(&facets, i.roughness, i.color)) }
    }
}

/// The reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn value<R: Real>(facets: &Facets<R>, roughness: R, color: Color<R>) -> Color<R> {
    // What grazing light is reflected by, less 1.
    let grazing = roughness * facets.squared() * 0.5 - 0.5;
    let share = fade(grazing, facets.cosine_in) * fade(grazing, facets.cosine_out);
    color * (share * (1.0 / PI))
}

/// `1 + (f - 1) (1 - cosine)^5`.
#[inline(always)]
fn fade<R: Real>(grazing: R, cosine: R) -> R {
    let one = cosine.same(1.0);
    let off = (one - cosine).saturate();
    let squared = off * off;
    grazing.mul_add(squared * squared * off, one)
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    /// By the formula as it is published, in 64 bits.
    #[test]
    fn it_has_the_values_of_the_paper() {
        for (light, viewer) in [
            ([0.6, 0.0, 0.8], [0.0, 0.6, 0.8]),
            ([0.96, 0.0, 0.28], [-0.8, 0.0, 0.6]),
            ([0.0, 0.0, 1.0], [0.28, 0.0, 0.96]),
        ] {
            for roughness in [0.0, 0.25, 1.0] {
                let half = [0, 1, 2].map(|k| light[k] + viewer[k]);
                let length = half.iter().map(|x: &f64| x * x).sum::<f64>().sqrt();
                let along = (0..3).map(|k| half[k] * light[k]).sum::<f64>() / length;
                let grazing = 0.5 + 2.0 * roughness * along * along;
                let fresnel = |cosine: f64| 1.0 + (grazing - 1.0) * (1.0 - cosine).powi(5);
                let expected = 0.7 * fresnel(light[2]) * fresnel(viewer[2]) / std::f64::consts::PI;
                let ray = viewer.map(|x| -x as f32);
                let found = numbers!(normal = UP, direction = light.map(|x| x as f32), ray = ray, roughness = roughness as f32, color = [0.7, 0.0, 0.7, 0.3] => value);
                let expected = [expected, 0.0, expected, 1.0];
                crate::nodes::harness::assert_close(&found, &expected, 1e-6, 1e-7);
            }
        }
    }

    #[test]
    fn head_on_it_is_lamberts() {
        for roughness in [0.0, 0.5, 1.0] {
            let value =
                numbers!(normal = UP, direction = UP, ray = DOWN, roughness = roughness => value);
            assert_eq!(value[0], std::f32::consts::FRAC_1_PI);
        }
    }

    #[test]
    fn nothing_is_reflected_from_behind() {
        for direction in [DOWN, [1.0, 0.0, 0.0], [0.0; 3], [f32::NAN; 3]] {
            let from_behind = numbers!(normal = UP, direction = direction, ray = DOWN => value);
            assert_eq!(from_behind, [0.0, 0.0, 0.0, 1.0]);
            assert_eq!(numbers!(normal = UP, direction = UP, ray = UP => value)[0], 0.0);
        }
    }
}
