//! Rendering: queues of rays, batches of points, tiles on threads.

mod clock;
mod context;
mod lighting;
mod points;
mod statistics;
mod tiles;

pub use context::Context;
pub use statistics::{RayCounts, Statistics};
pub use tiles::{RenderError, Rendered, SAMPLE_LIMIT, Settings, render};
