//! The schedule: a specialised graph as regions of segments, forces, requests and loops, which the
//! batch and jit engines run over many points at once.
//!
//! A *region* is what is demanded under one mask. *Pure* instances, which ask nothing of the
//! renderer, are evaluated for all points, in segments; whether a point asked for them cannot be
//! seen. What is heavy and wanted under a condition is left out of blocks in which no point wants it. Instances that ask something, or read the answer, are run under the exact mask the walk
//! would demand them under: those demanded once, without guard, inside the region of who demands
//! them; all others as regions of their own, which a *force* runs on `mask and not done`.
//!
//! A region may run several times, each time for further points. It recomputes its pure parts for
//! all points; where they were valid before they come out the same.

mod build;
mod conditions;
mod ids;
mod print;
mod pure;
mod queue;
mod regions;
mod verify;

pub use build::schedule;
pub use ids::{LoopId, RegionId, RequestId, SegmentId};
pub use pure::LEAST_SKIPPED;
pub use regions::{Item, Loop, Region, Request, Schedule, Segment, Step};
pub use verify::verify;
