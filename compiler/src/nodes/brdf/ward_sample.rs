use crate::emit::Vector;
use crate::emit::functions::distributions::{BECKMANN, roughness};
use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::{drawn_slope, mirrored_at, turned};
use crate::nodes::brdf::ward_density::density;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// A direction mirrored at a half vector drawn from Ward's Gaussian: what suits `ward_brdf`. The half vector
    /// comes from its slopes, each scaled by its roughness: no quadrant has to be told from its neighbours.
    ward_sample in brdf,
    source "Walter 2005, Notes on the Ward BRDF",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness across it.
        roughness_v: scalar = 0.2, in UNIT;
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
        let frame = Frame::along(i.normal, i.tangent);
        let (u, v) = (roughness(i.roughness_u), roughness(i.roughness_v));
        let slope = drawn_slope(BECKMANN, i.first, e.real(1.0));
        let (x, y) = turned(i.second);
        let local = Vector { x: x * slope * u, y: y * slope * v, z: e.real(1.0) };
        let half = frame.world(local).normalized();
        let direction = mirrored_at(half, i.ray);
        let facets = Facets::of(i.normal, direction, i.ray);
        Outputs { direction, density: density(&facets, &frame, u, v) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_first_number_of_zero_is_the_mirror() {
        let direction = numbers!(normal = [0.0, 0.0, 1.0], ray = [0.6, 0.0, -0.8], first = 0.0, second = 0.3 => direction);
        crate::nodes::harness::assert_close(&direction, &[0.6, 0.0, 0.8], 1e-6, 1e-7);
    }
}
