//! Scenes: what is rendered.

mod build;
mod called_for;
mod depth;
mod object;
mod surfaces;

pub(crate) use build::placed_sphere;
pub use build::{Scene, SceneBuilder, SceneError};
pub use depth::{DEPTH_LIMIT, TraceDepth};
