//! Scenes: what is rendered.

mod build;
mod depth;

pub use build::{Scene, SceneBuilder, SceneError};
pub use depth::TraceDepth;
