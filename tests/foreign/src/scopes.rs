//! Scopes over fields that no standard scope changes, so that every field a ray can carry is changed by
//! some scope; and over values of other types than colours.

use phenomenon_compiler::nodes::Definition;

/// The nodes.
pub fn definitions() -> [Definition; 3] {
    [enter_medium::definition(), turn::definition(), flip::definition()]
}

/// The node `enter_medium`.
pub mod enter_medium {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::{BLACK, state};
    use phenomenon_compiler::state::Field;

    node! {
        /// Evaluates `input` with other indices of refraction.
        enter_medium in foreign scope [Ior, IorIn],
        source "",
        inputs {
            /// The index outside.
            ior: scalar = 1.5;
            /// The index inside.
            ior_in: scalar = state(Field::Ior);
        }
        scoped {
            /// What is evaluated.
            input: color = BLACK;
        }
        changes { ior: scalar; ior_in: scalar; }
        outputs {
            /// The value of `input`.
            color: color;
        }
        body |e, i| Changes { ior: i.ior, ior_in: i.ior_in }
    }
}

/// The node `flip`.
pub mod flip {
    use std::ops::Not;

    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::state;
    use phenomenon_compiler::state::Field;

    node! {
        /// Whether `input` holds as if the surface were hit from the other side.
        flip in foreign scope [InvNormal],
        source "",
        inputs {
            /// Whether it is hit from inside.
            inside: boolean = state(Field::InvNormal);
        }
        scoped {
            /// What is evaluated.
            input: boolean = false;
        }
        changes { inv_normal: boolean; }
        outputs {
            /// Whether it holds there.
            truth: boolean;
        }
        body |e, i| Changes { inv_normal: i.inside.not() }
    }
}

/// The node `turn`.
pub mod turn {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::state;
    use phenomenon_compiler::state::Field;

    node! {
        /// Evaluates `input` with another direction and another time.
        turn in foreign scope [Direction, Time],
        source "",
        inputs {
            /// The direction.
            direction: vector = state(Field::Normal);
            /// The time.
            time: scalar = state(Field::U);
        }
        scoped {
            /// What is evaluated.
            input: generic = 0.0;
        }
        changes { direction: vector; time: scalar; }
        outputs {
            /// The value of `input`.
            value: generic;
        }
        body |e, i| Changes { direction: i.direction, time: i.time }
    }
}
