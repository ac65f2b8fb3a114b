use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::{drawn, mirrored_at, turned};
use crate::emit::{Real, Vector};
use crate::nodes::brdf::phong_density::density;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// A direction about the mirrored ray, as dense as a power of the cosine from it: what suits `phong_brdf`.
    phong_sample in brdf,
    source "Lafortune and Willems 1994, Using the Modified Phong Reflectance Model for Physically Based Rendering",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// How narrow the lobe is.
        exponent: scalar = 20.0, in 0.0..=1e8, soft 1.0..=1000.0;
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
        let mirror = mirrored_at(i.normal, i.ray);
        // 1 - cos and sin^2, where cos^(exponent + 1) is drawn.
        let log = (-drawn(i.first)).log1p() / (i.exponent + 1.0);
        let off = -log.expm1();
        let sine = (off * (e.real(2.0) - off)).sqrt();
        let (x, y) = turned(i.second);
        let local = Vector { x: x * sine, y: y * sine, z: e.real(1.0) - off };
        let direction = Frame::around(mirror).world(local).normalized();
        Outputs { direction, density: density(&Facets::of(i.normal, direction, i.ray), i.exponent) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_first_number_of_zero_is_the_mirror() {
        let ray = [0.6, 0.0, -0.8];
        let direction =
            numbers!(normal = [0.0, 0.0, 1.0], ray = ray, first = 0.0, second = 0.3 => direction);
        crate::nodes::harness::assert_close(&direction, &[0.6, 0.0, 0.8], 1e-6, 1e-7);
    }
}
