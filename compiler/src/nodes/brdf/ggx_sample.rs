use crate::emit::functions::conventions::sqrt_or_zero;
use crate::emit::functions::distributions::roughness;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::{drawn, mirrored_at, turned};
use crate::emit::{Real, Vector};
use crate::nodes::brdf::ggx_brdf::Ggx;
use crate::nodes::brdf::ggx_density::density;
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// A direction mirrored at a facet that the viewer sees: what suits `ggx_brdf`. Scaled by the roughness the
    /// facets become a hemisphere, whose visible normals are the sum of the viewer's direction and one of a
    /// spherical cap.
    ggx_sample in brdf,
    source "Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps; Heitz 2018",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness alpha along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness alpha across it.
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
        let viewer = -frame.local(i.ray);
        let flat = Vector { x: viewer.x * u, y: viewer.y * v, z: viewer.z }.normalized();
        let one = e.real(1.0);
        let (x, y) = turned(i.second);
        let z = (one - drawn(i.first)).mul_add(flat.z + 1.0, -flat.z);
        let radius = sqrt_or_zero((one - z) * (one + z));
        let (x, y) = (x * radius + flat.x, y * radius + flat.y);
        let half = frame.world(Vector { x: x * u, y: y * v, z: z + flat.z }).normalized();
        let direction = mirrored_at(half, i.ray);
        let ggx = Ggx::of(&frame, direction, i.ray, u, v);
        Outputs { direction, density: density(&ggx) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_first_number_of_zero_is_the_mirror_head_on() {
        let up = [0.0, 0.0, 1.0];
        let direction =
            numbers!(normal = up, ray = [0.0, 0.0, -1.0], first = 0.0, second = 0.3 => direction);
        crate::nodes::harness::assert_close(&direction, &[0.0, 0.0, 1.0], 1e-6, 1e-6);
    }
}
