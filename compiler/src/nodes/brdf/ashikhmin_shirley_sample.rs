use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::{drawn, mirrored_at, mirrored_density, turned};
use crate::emit::{Real, Vector};
use crate::nodes::brdf::ashikhmin_shirley_brdf::lobe;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// A direction mirrored at a half vector drawn from the coat of `ashikhmin_shirley_brdf`. The half vector's
    /// direction along the surface comes from a circle that is stretched: no quadrant has to be told from its
    /// neighbours.
    ashikhmin_shirley_sample in brdf,
    source "Ashikhmin and Shirley 2000, An Anisotropic Phong BRDF Model",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `exponent_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// How narrow the lobe is along the tangent.
        exponent_u: scalar = 10.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// How narrow it is across.
        exponent_v: scalar = 100.0, in 0.0..=1e8, soft 1.0..=1e4;
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
        let (a, b) = (i.exponent_u + 1.0, i.exponent_v + 1.0);
        let (x, y) = turned(i.second);
        let (x, y) = (x * b.sqrt(), y * a.sqrt());
        let length = x.mul_add(x, y * y).sqrt();
        let (x, y) = (x / length, y / length);
        let exponent = (i.exponent_u * x).mul_add(x, i.exponent_v * y * y);
        // tan^2, where cos^(exponent + 1) is drawn.
        let slope = ((-drawn(i.first)).log1p() * -2.0 / (exponent + 1.0)).expm1().sqrt();
        let half = frame.world(Vector { x: x * slope, y: y * slope, z: e.real(1.0) }).normalized();
        let direction = mirrored_at(half, i.ray);
        let facets = Facets::of(i.normal, direction, i.ray);
        Outputs { direction, density: mirrored_density(&facets, lobe(&facets, &frame, i.exponent_u, i.exponent_v)) }
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
