use crate::emit::functions::facets::Facets;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::lobes::mirrored_density;
use crate::nodes::brdf::ashikhmin_shirley_brdf::lobe;
use crate::nodes::{NOT_NEGATIVE, node, state};
use crate::state::Field;

node! {
    /// Density of a direction among those of `ashikhmin_shirley_sample`:
    /// `sqrt((a + 1) (b + 1)) / (2 pi) (n·h)^e / (4 h·v)`.
    ashikhmin_shirley_density in brdf,
    source "Ashikhmin and Shirley 2000, An Anisotropic Phong BRDF Model",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `exponent_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// How narrow the lobe is along the tangent.
        exponent_u: scalar = 10.0, in 0.0..=1e8, soft 1.0..=1e4;
        /// How narrow it is across.
        exponent_v: scalar = 100.0, in 0.0..=1e8, soft 1.0..=1e4;
    }
    outputs {
        /// The density, per steradian.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let facets = Facets::of(i.normal, i.direction, i.ray);
        let frame = Frame::along(i.normal, i.tangent);
        let of_half = lobe(&facets, &frame, i.exponent_u, i.exponent_v);
        Outputs { density: mirrored_density(&facets, of_half) }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_peak_is_known() {
        let density = number!(normal = [0.0, 0.0, 1.0], direction = [0.0, 0.0, 1.0], ray = [0.0, 0.0, -1.0], exponent_u = 8.0, exponent_v = 3.0 => density);
        crate::nodes::harness::assert_close(
            &[density],
            &[6.0 / (8.0 * std::f64::consts::PI)],
            1e-6,
            0.0,
        );
    }
}
