use crate::emit::functions::distributions::{BECKMANN, CAVITY, roughness};
use crate::emit::functions::facets::Facets;
use crate::emit::functions::reflected::shown;
use crate::emit::{Color, Real};
use crate::nodes::brdf::torrance_sparrow_brdf::specular;
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_conductor::reflectance;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Reflectance of a rough metal: small mirrors of Beckmann's distribution that hide each other as sides
    /// of grooves do, with Fresnel's reflectance of a conductor for each colour: `D G F / (4 (n·l) (n·v))`, 4
    /// where Cook and Torrance print pi. Draw directions by `microfacet_sample`. Reciprocal, and at most all
    /// light is reflected.
    ///
    /// mental ray's `mi_cooktorr_specular` is of this kind; what it computes exactly is not published. Its
    /// colour of indices is `ior`, with an `extinction` of 0.
    cook_torrance_brdf in brdf,
    source "Cook and Torrance 1982, A Reflectance Model for Computer Graphics",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Root mean square slope of the facets.
        roughness: scalar = 0.3, in UNIT;
        /// Index of refraction for each colour; that of gold unless given.
        ior: color = [0.18, 0.42, 1.37, 1.0], in 0.0..=100.0, soft 0.1..=5.0;
        /// Extinction coefficient for each colour; that of gold unless given.
        extinction: color = [3.42, 2.35, 1.77, 1.0], in 0.0..=100.0, soft 0.0..=10.0;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        Outputs { value: shown(facets.above(), value(&facets, i.roughness, i.ior, i.extinction)) }
    }
}

/// The reflectance where light and viewer are above the surface.
#[inline(always)]
pub fn value<R: Real>(
    facets: &Facets<R>,
    rough: R,
    ior: Color<R>,
    extinction: Color<R>,
) -> Color<R> {
    let cosine = facets.cosine_half();
    let mirrors = specular(facets, roughness(rough), BECKMANN, CAVITY);
    let fresnel = Color {
        r: reflectance(ior.r, extinction.r, cosine),
        g: reflectance(ior.g, extinction.g, cosine),
        b: reflectance(ior.b, extinction.b, cosine),
        a: ior.a,
    };
    fresnel * mirrors
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_the_metals_reflectance_times_the_peak() {
        let value = numbers!(normal = UP, direction = UP, ray = DOWN, roughness = 0.5, ior = [0.2, 1.5, 1.0, 1.0], extinction = [3.9, 0.0, 0.0, 1.0] => value);
        let peak = 1.0 / (std::f64::consts::PI * 0.25) / 4.0;
        crate::nodes::harness::assert_close(
            &value[..3],
            &[0.951_951_951_951_95 * peak, 0.04 * peak, 0.0],
            1e-6,
            0.0,
        );
    }
}
