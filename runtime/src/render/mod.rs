//! Rendering: queues of rays, batches of points, tiles on threads.

mod clock;
mod context;
mod empty_scene;
mod light_lists;
mod lighting;
mod points;
mod requests;
mod roots;
mod scratch;
mod statistics;
mod tiles;

pub use context::Context;
pub use empty_scene::EmptyScene;
pub use roots::CALLED_ROOTS;
pub use statistics::{RayCounts, Statistics};
pub use tiles::{Region, RenderError, Rendered, SAMPLE_LIMIT, Settings, render, render_region};
