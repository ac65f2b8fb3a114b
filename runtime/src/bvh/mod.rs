//! The tree over all primitives of a scene.

mod node;
mod tree;

pub use tree::{PrimitiveId, Tree, TreeError};
