//! Nodes that ask the renderer: they declare what they want of the answer, in any order.

use phenomenon_compiler::nodes::Definition;

/// The nodes.
pub fn definitions() -> [Definition; 2] {
    [colour_of_mirror::definition(), reach_of_mirror::definition()]
}

/// The node `colour_of_mirror`: a mirror that wants the colour alone.
pub mod colour_of_mirror {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::{NOT_NEGATIVE, node};

    node! {
        /// The colour a mirror shows.
        colour_of_mirror in foreign request TraceReflection,
        source "",
        inputs {
            /// Direction of the ray.
            direction: vector = node("reflection_direction");
        }
        outputs {
            /// Colour seen along the ray.
            color: color, in NOT_NEGATIVE;
        }
    }
}

/// The node `reach_of_mirror`: a mirror that wants the end of the answer first, and no colour.
pub mod reach_of_mirror {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::{NOT_NEGATIVE, node};

    node! {
        /// How far a mirror sees.
        reach_of_mirror in foreign request TraceReflection,
        source "",
        inputs {
            /// Direction of the ray.
            direction: vector = node("reflection_direction");
        }
        outputs {
            /// Distance to what is seen.
            distance: scalar, in NOT_NEGATIVE;
            /// Whether anything is.
            hit: boolean;
        }
    }
}
