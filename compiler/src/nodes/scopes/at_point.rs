use crate::nodes::{required, state};
use crate::state::Field;

node! {
    /// Evaluates `input` as if the point were elsewhere: a pattern that is shifted, turned or bent by another. All
    /// that reads the point, directly or through others, is evaluated anew there, requests included: rays
    /// start there, and light falls there; all others are shared with the outside. Surface coordinates and the
    /// normal stay: see `at_uv` and `perturb_normal`.
    at_point in scopes scope [Point],
    source "OSL 1.13, transform of the space a pattern is evaluated in",
    inputs {
        /// The point to use, in world space.
        point: vector = state(Field::Point);
    }
    scoped {
        /// What is evaluated there.
        input: generic = required();
    }
    changes { point: vector; }
    outputs {
        /// Its value there.
        result: generic;
    }
    body |e, i| Changes { point: i.point }
}

#[cfg(test)]
mod tests {
    use crate::nodes::Kind;
    use crate::state::Field;
    use crate::values::Type;

    #[test]
    fn changes_the_point_for_values_of_every_type() {
        let definition = super::definition();
        assert_eq!(definition.signature.kind, Kind::Scope(vec![Field::Point]));
        let types: Vec<_> = definition.overloads.iter().filter_map(|form| form.generic).collect();
        assert_eq!(types, Type::GENERIC);
    }
}
