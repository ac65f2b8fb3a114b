//! What cannot be specialised.

/// Why a graph could not be specialised.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub enum SpecialiseError {
    /// Scopes nested in scopes can multiply nodes.
    #[error(
        "the graph expands to more than {limit} evaluations, most of them copies of `{node}` and its \
         inputs inside nested scopes; share less between the inside and the outside of a scope"
    )]
    TooManyInstances {
        /// The limit, [`MAX_INSTANCES`](super::MAX_INSTANCES).
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
        /// The limit, [`MAX_NESTED_LOOPS`](super::MAX_NESTED_LOOPS).
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
