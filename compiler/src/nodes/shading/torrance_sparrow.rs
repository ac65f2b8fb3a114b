use crate::emit::functions::distributions::{DISTRIBUTIONS, GEOMETRIES, roughness};
use crate::emit::functions::facets::{Facets, lit};
use crate::emit::functions::reflected::reflected;
use crate::nodes::brdf::torrance_sparrow_brdf::specular;
use crate::nodes::finite::{INTENSITY, UNIT};
use crate::nodes::fresnel::fresnel_dielectric::{index, reflectance};
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Light of one sample on small mirrors: `color light (n·l)` times `torrance_sparrow_brdf`.
    /// Black where light or viewer is behind the surface, and there no light is asked for: no shadow ray is
    /// cast. Alpha is 1. Belongs into the body of a light loop.
    torrance_sparrow in shading,
    source "Torrance and Sparrow 1967; see `torrance_sparrow_brdf`",
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
        /// The light reflected.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let fresnel = reflectance(e, index(e, i.ior_in), index(e, i.ior), facets.cosine_half());
        let mirrors = specular(&facets, roughness(i.roughness), i.distribution, i.geometry);
        let factor = mirrors * fresnel * facets.cosine_in;
        Outputs { color: reflected(facets.above(), i.color, i.light, factor) }
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    const DOWN: [f32; 3] = [0.0, 0.0, -1.0];

    #[test]
    fn head_on_it_is_fresnels_share_of_the_peak() {
        let shaded = number!(normal = UP, direction = UP, ray = DOWN, light = [1.0; 4], roughness = 0.5 => color);
        crate::nodes::harness::assert_close(&[shaded], &[0.04 / std::f64::consts::PI], 1e-6, 0.0);
    }
}
