use crate::emit::functions::distributions::{SAMPLED_DISTRIBUTIONS, roughness};
use crate::emit::functions::facets::Facets;
use crate::emit::functions::lobes::facet_density;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `microfacet_sample`: `D (h·n) / (4 h·v)`.
    microfacet_density in brdf,
    source "Walter and others 2007, Microfacet Models for Refraction through Rough Surfaces",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Root mean square slope of the facets.
        roughness: scalar = 0.3, in UNIT;
        /// The distribution of their normals.
        distribution: choice = 0, of SAMPLED_DISTRIBUTIONS;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        Outputs { density: facet_density(i.distribution, &facets, roughness(i.roughness)) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_peaks_are_known() {
        for distribution in 0..3 {
            let density = number!(normal = [0.0, 0.0, 1.0], direction = [0.0, 0.0, 1.0], ray = [0.0, 0.0, -1.0], roughness = 0.5, distribution = distribution => density);
            crate::nodes::harness::assert_close(
                &[density],
                &[1.0 / std::f64::consts::PI],
                1e-6,
                0.0,
            );
        }
    }
}
