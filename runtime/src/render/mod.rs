//! Rendering: queues of rays, batches of points, tiles on threads.

mod all_effects;
mod clock;
mod context;
mod costs;
mod empty_scene;
mod entry;
mod environment_light;
mod light_lists;
mod lighting;
mod lookups;
mod points;
mod requests;
mod roots;
mod scratch;
mod statistics;
mod tiles;

pub use context::Context;
pub use costs::{Cost, Costs};
pub use empty_scene::EmptyScene;
pub use entry::{Entry, Unit};
pub use roots::CALLED_ROOTS;
pub use statistics::{RayCounts, Statistics};
pub use tiles::{Region, RenderError, Rendered, SAMPLE_LIMIT, Settings, render, render_region};
