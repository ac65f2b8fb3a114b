//! Why a graph cannot be drawn.

/// Most boxes (parameters, nodes, roots and outputs) of an SVG. Larger drawings can be neither read nor
/// opened; DOT has no limit.
pub const MAX_BOXES: usize = 5_000;

/// Why a graph cannot be drawn.
#[derive(Clone, Debug, thiserror::Error, PartialEq, Eq)]
pub enum ShowError {
    /// More boxes than [`MAX_BOXES`].
    #[error(
        "the graph has {boxes} boxes (parameters, nodes, roots and outputs), more than the {limit} an SVG is \
         drawn of"
    )]
    TooManyBoxes {
        /// How many it has.
        boxes: usize,
        /// The limit, [`MAX_BOXES`].
        limit: usize,
    },
    /// The graph was not made for this library, or was not checked.
    #[error("the graph does not fit its node library at `{place}`: {problem}")]
    Inconsistent {
        /// The node, the root or the graph.
        place: String,
        /// What does not fit.
        problem: String,
    },
}
