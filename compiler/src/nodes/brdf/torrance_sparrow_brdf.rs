use crate::emit::Real;
use crate::emit::functions::distributions::{
    DISTRIBUTIONS, GEOMETRIES, distribution, roughness, visibility,
};
use crate::emit::functions::facets::Facets;
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_dielectric::{index, reflectance};
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Reflectance of small mirrors: `D G F / (4 (n·l) (n·v))`, D being the distribution of their normals, G
    /// the share that is seen and lit, F Fresnel's reflectance of a dielectric at the half vector. Draw
    /// directions by `microfacet_sample`.
    ///
    /// The roughness `m` is that of Beckmann's distribution `exp(-tan^2 / m^2) / (pi m^2 cos^4)`; `ellipsoid` is
    /// Trowbridge and Reitz's (GGX) with alpha = m, `power` is Blinn's cosine power with the exponent
    /// `2 / m^2 - 2`, `gaussian` is `exp(-(angle / m)^2) / (pi m^2)`. `cavity` is Torrance and Sparrow's G,
    /// `smith` Smith's for ellipsoids, each side for itself, `correlated` both heights together. Reciprocal, and
    /// at most all light is reflected (measured: 0.996 for m = 0.3 and F = 1), save by the Gaussian one, which
    /// is normalised only as far as m is small. A roughness below 10^-6 counts as that.
    torrance_sparrow_brdf in brdf,
    source "Torrance and Sparrow 1967; Blinn 1977; Beckmann and Spizzichino 1963; Walter and others 2007",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Root mean square slope of the facets.
        roughness: scalar = 0.3, in UNIT;
        /// Index of refraction of the surface.
        ior: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction of what surrounds it.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
        /// The distribution of their normals.
        distribution: choice = 0, of DISTRIBUTIONS;
        /// How they hide each other.
        geometry: choice = 0, of GEOMETRIES;
    }
    outputs {
        /// The reflectance, per steradian.
        value: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let m = roughness(i.roughness);
        let fresnel = reflectance(e, index(e, i.ior_in), index(e, i.ior), facets.cosine_half());
        let value = specular(&facets, m, i.distribution, i.geometry) * fresnel;
        Outputs { value: facets.where_above(value) }
    }
}

/// The reflectance of perfect mirrors, where light and viewer are above the surface.
#[inline(always)]
pub fn specular<R: Real>(facets: &Facets<R>, roughness: R, spread: i32, geometry: i32) -> R {
    let facing = distribution(spread, facets.slope_squared(), roughness);
    facing * visibility(geometry, facets, roughness)
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    /// Values times cosine of others, F = 1: the ratio of both ways to hide is free of the rest.
    #[test]
    fn smiths_two_forms_stand_to_each_other_as_others_have_it() {
        for (outer, inner, turn, separate, correlated) in
            [(60.0, 60.0, 170.0, 0.4146561, 0.4228253), (75.0, 80.0, 180.0, 0.3894247, 0.474614)]
        {
            let at = |angle: f64, turn: f64| {
                let (angle, turn) = (angle.to_radians(), turn.to_radians());
                [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()]
            };
            let direction = at(inner, turn).map(|x| x as f32);
            let ray = at(outer, 0.0).map(|x| -x as f32);
            let value = |geometry: i32| number!(normal = UP, direction = direction, ray = ray, roughness = 0.5, distribution = 1, geometry = geometry => value);
            let expected: f64 = separate / correlated;
            crate::nodes::harness::assert_close(&[value(1) / value(2)], &[expected], 2e-6, 0.0);
        }
    }
}
