//! What specialising left out, kept for whoever asks why.

use crate::state::Field;

/// What was decided while a graph was specialised. Nodes are positions in the views of the graph for its root.
#[derive(Clone, Debug, Default)]
pub struct Decisions {
    /// Inputs that are never asked for.
    pub(super) folds: Vec<Fold>,
    /// Of each node, whether anything may ask for it.
    pub(super) built: Vec<bool>,
    /// Fields of the state in use, each with a node that reads it; one that is evaluated in several places stands here
    /// several times.
    pub(super) readers: Vec<(Field, usize)>,
    /// Requests that ask nothing, for want of a texture or of a loop round them.
    pub(super) about_nothing: Vec<usize>,
}

/// An input that is never asked for: its guard looks at uniform words alone, and does not hold.
#[derive(Clone, Debug)]
pub(super) struct Fold {
    /// The node.
    pub view: usize,
    /// Its input.
    pub input: usize,
    /// The uniform words of the node's inputs, by position, as the guard is given them.
    pub words: Vec<u32>,
    /// Which of them the guard looks at.
    pub looks: Vec<bool>,
}
