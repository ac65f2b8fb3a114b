use super::fresnel_dielectric::index;
use crate::emit::{Emit, Mask};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// The indices of refraction on both sides of the boundary the ray meets, in the ray's order.
    /// Entering, it comes from the incoming medium of the state (unset: 1) into the material; leaving,
    /// from the material into the outgoing medium of the state (unset: 1).
    ior_pair in fresnel,
    source "mental ray base shaders, mib_refraction_index",
    inputs {
        /// Index of refraction of the material.
        ior: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Whether the surface was hit from inside.
        inside: boolean = state(Field::InvNormal);
        /// Index of the medium the ray enters from.
        medium_in: scalar = state(Field::IorIn), in 0.0..=100.0;
        /// Index of the medium the ray leaves into.
        medium_out: scalar = state(Field::Ior), in 0.0..=100.0;
    }
    outputs {
        /// Index on the side the ray comes from.
        ior_in: scalar, in 1.0 / 64.0..=100.0;
        /// Index beyond the boundary.
        ior_out: scalar, in 1.0 / 64.0..=100.0;
        /// Whether the ray enters the material.
        enter: boolean;
    }
    body |e, i| {
        let (ior_in, ior_out) = pair(e, i.ior, i.inside, i.medium_in, i.medium_out);
        Outputs { ior_in, ior_out, enter: !i.inside }
    }
}

/// The two indices in the ray's order.
#[inline(always)]
pub fn pair<E: Emit>(
    e: E,
    ior: E::Real,
    inside: E::Mask,
    medium_in: E::Real,
    medium_out: E::Real,
) -> (E::Real, E::Real) {
    let material = index(e, ior);
    let ior_in = inside.select(material, index(e, medium_in));
    let ior_out = inside.select(index(e, medium_out), material);
    (ior_in, ior_out)
}

#[cfg(test)]
mod tests {
    #[test]
    fn unset_media_are_air() {
        assert_eq!(number!(ior = 1.5 => ior_in), 1.0);
        assert_eq!(number!(ior = 1.5 => ior_out), 1.5);
        assert!(truth!(ior = 1.5 => enter));
        assert_eq!(number!(ior = 1.5, inside = true => ior_in), 1.5);
        assert_eq!(number!(ior = 1.5, inside = true => ior_out), 1.0);
        assert!(!truth!(ior = 1.5, inside = true => enter));
    }

    #[test]
    fn media_of_the_state_count_on_their_side() {
        assert_eq!(number!(ior = 1.5, medium_in = 1.33, medium_out = 2.0 => ior_in), 1.33);
        assert_eq!(
            number!(ior = 1.5, inside = true, medium_in = 1.33, medium_out = 2.0 => ior_out),
            2.0
        );
    }

    #[test]
    fn nonsense_is_air() {
        for ior in [0.0, -0.0, -3.0, f32::NAN, f32::NEG_INFINITY] {
            assert_eq!(number!(ior = ior => ior_out), 1.0);
        }
        assert_eq!(number!(ior = f32::INFINITY => ior_out), 100.0);
        assert_eq!(number!(ior = 1e-45 => ior_out), 1.0 / 64.0);
    }
}
