use crate::emit::Vector;
use crate::emit::functions::distributions::{SAMPLED_DISTRIBUTIONS, roughness};
use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::{drawn_slope, facet_density, mirrored_at, turned};
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// A direction mirrored at a facet drawn from a distribution times the cosine: what suits
    /// `torrance_sparrow_brdf` (for its Gaussian distribution take Beckmann's), `cook_torrance_brdf`
    /// (Beckmann's), and `schlick_anisotropic_brdf` (that of ellipsoids, with the root of its roughness).
    microfacet_sample in brdf,
    source "Walter and others 2007, Microfacet Models for Refraction through Rough Surfaces",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Root mean square slope of the facets.
        roughness: scalar = 0.3, in UNIT;
        /// The distribution of their normals.
        distribution: choice = 0, of SAMPLED_DISTRIBUTIONS;
        /// First number the direction is drawn by, 0 to below 1; by default that of the sample.
        first: scalar = state(Field::SampleU), in UNIT;
        /// Second number the direction is drawn by, 0 to below 1; by default that of the sample.
        second: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// Unit direction towards where the light comes from; it may lie below the surface, where nothing is reflected.
        direction: vector, in -1.0..=1.0;
        /// Density of that direction, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let m = roughness(i.roughness);
        let slope = drawn_slope(i.distribution, i.first, m);
        let (x, y) = turned(i.second);
        let local = Vector { x: x * slope, y: y * slope, z: e.real(1.0) };
        let half = Frame::around(i.normal).world(local).normalized();
        let direction = mirrored_at(half, i.ray);
        let facets = Facets::of(i.normal, direction, i.ray);
        Outputs { direction, density: facet_density(i.distribution, &facets, m) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_first_number_of_zero_is_the_mirror() {
        for distribution in 0..3 {
            let direction = numbers!(normal = [0.0, 0.0, 1.0], ray = [0.6, 0.0, -0.8], distribution = distribution, first = 0.0, second = 0.3 => direction);
            crate::nodes::harness::assert_close(&direction, &[0.6, 0.0, 0.8], 1e-6, 1e-7);
        }
    }
}
