//! A checked graph, made concrete for one root and one ray type: every node evaluation that can be
//! demanded becomes an [`Instance`], in the epoch it belongs to, with all names resolved to words.

mod epochs;
mod expand;
mod instances;
pub mod internal;
mod reads;
mod uniforms;
mod views;

pub use epochs::{Epoch, EpochId, EpochKind, Epochs};
pub use expand::{MAX_INSTANCES, MAX_NESTED_LOOPS, expand, mix_key};
pub use instances::{
    Context, Demand, Guard, Instance, InstanceId, InstanceKind, LightTable, Specialised,
};
pub use reads::FieldSet;
pub use uniforms::Uniforms;

/// Why a graph could not be specialised.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub enum SpecialiseError {
    /// Scopes nested in scopes can multiply nodes.
    #[error(
        "the graph expands to more than {limit} evaluations, most of them copies of `{node}` and its \
         inputs inside nested scopes; share less between the inside and the outside of a scope"
    )]
    TooManyInstances {
        /// The limit, [`MAX_INSTANCES`].
        limit: usize,
        /// A node that was being expanded.
        node: String,
    },
    /// Loops in loops run their bodies for every combination of light samples.
    #[error(
        "`{node}` is the body of more than {limit} light loops, one inside the other, each over the \
         light of the one outside; take it out of some"
    )]
    TooManyLoops {
        /// The limit, [`MAX_NESTED_LOOPS`].
        limit: usize,
        /// The innermost loop.
        node: String,
    },
    /// The graph was not made for this library, or was not checked.
    #[error("the graph does not fit its node library at `{node}`: {problem}")]
    Inconsistent {
        /// The node.
        node: String,
        /// What does not fit.
        problem: String,
    },
}
