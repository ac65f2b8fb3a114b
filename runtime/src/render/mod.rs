//! Rendering: queues of rays, batches of points, tiles on threads.

mod clock;
mod context;
mod lighting;
mod points;
mod statistics;
mod tiles;

use phenomenon_compiler::graph::RootKind;

pub use context::Context;
pub use statistics::{RayCounts, Statistics};
pub use tiles::{Region, RenderError, Rendered, SAMPLE_LIMIT, Settings, render, render_region};

/// The shader types this renderer calls. Roots of other types are checked and compiled by whoever
/// wants them, but no picture depends on them.
pub const CALLED_ROOTS: &[RootKind] =
    &[RootKind::Material, RootKind::Shadow, RootKind::Environment];
