//! What lies round a point: scopes and turns of loops.

use crate::effects::LightList;
use crate::state::Field;

use crate::testing::reads::Fields;

/// Position in the tree of surroundings; 0 is the point itself.
pub(super) type SurroundingsId = usize;

/// What a scope or a turn of a loop puts round its inside.
pub(super) struct Surroundings {
    pub(super) outside: SurroundingsId,
    pub(super) changes: Fields,
    /// Name of the scope or loop.
    pub(super) name: String,
    pub(super) inside_of: Inside,
}

/// What surroundings are those of.
pub(super) enum Inside {
    Point,
    /// The scope's node; its changed fields are computed when first read.
    Scope {
        node: usize,
        fields: Option<Vec<(Field, Vec<u32>)>>,
    },
    /// A turn of a loop.
    Turn {
        number: usize,
        /// Of a loop over lights: its list, and the token of the sample.
        light: Option<(LightList, u64)>,
        fields: Vec<(Field, Vec<u32>)>,
    },
}
