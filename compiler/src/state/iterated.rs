//! What loops run over.

use crate::values::Type;

/// Most turns of a loop over samples; a count beyond it is taken for it.
pub const MOST_TURNS: i32 = 1 << 16;

/// What a loop runs over. Each turn provides the fields of which
/// [`Field::of_loop`](super::Field::of_loop) says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Iterated {
    /// The samples of a list of lights, as far as they can reach the point.
    Lights,
    /// As many samples as are asked for, each with numbers drawn for it.
    Samples,
}

impl Iterated {
    /// Every kind.
    pub const ALL: [Iterated; 2] = [Iterated::Lights, Iterated::Samples];

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Iterated::Lights => "light",
            Iterated::Samples => "sample",
        }
    }

    /// Types of the inputs a node over it has, before its scoped input. The integer of a loop over
    /// lights is a choice among [`LightMode::NAMES`](crate::effects::LightMode::NAMES).
    pub fn arguments(self) -> &'static [Type] {
        match self {
            Iterated::Lights => &[Type::Lights, Type::Integer],
            Iterated::Samples => &[Type::Integer],
        }
    }
}
