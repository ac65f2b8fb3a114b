//! The tree over all primitives of a scene.

mod build;
mod node;
mod split;
mod tree;

pub use tree::{PrimitiveId, Tree, TreeError};
