use crate::nodes::{required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` as if the surface coordinates were others: whatever reads them, textures and patterns alike,
    /// is placed by one node. All that reads them, directly or through others, is evaluated anew; all
    /// others are shared with the outside. The footprint stays that of the surface.
    at_uv in scopes scope [U, V],
    source "OSL 1.13, texture coordinates as arguments of every pattern",
    inputs {
        /// First coordinate to use.
        u: scalar = state(Field::U);
        /// Second coordinate to use.
        v: scalar = state(Field::V);
    }
    scoped {
        /// What is evaluated there.
        input: generic = required();
    }
    changes { u: scalar; v: scalar; }
    outputs {
        /// Its value there.
        result: generic;
    }
    body |e, i| Changes { u: i.u, v: i.v }
}

#[cfg(test)]
mod tests {
    use crate::values::Literal;

    #[test]
    fn hands_both_coordinates_on_to_the_bit() {
        let code = super::definition().overloads[0].code.expect("a scope has a body");
        let inputs = [-0.0, 1e-45].map(|x| Literal::Scalar(x).words()[0]);
        let mut changes = [0; 2];
        code.scalar(&[inputs[0], inputs[1], 0], &mut changes);
        assert_eq!(changes, inputs);
    }
}
