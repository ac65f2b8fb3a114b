//! Positions in a schedule, each of its own type.

use cranelift_entity::entity_impl;

/// Position in [`Schedule::regions`](super::Schedule::regions).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RegionId(u32);
entity_impl!(RegionId, "region");

impl RegionId {
    /// The region of the root.
    pub const ROOT: Self = Self(0);
}

/// Position in [`Schedule::segments`](super::Schedule::segments).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SegmentId(u32);
entity_impl!(SegmentId, "segment");

/// Position in [`Schedule::requests`](super::Schedule::requests).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RequestId(u32);
entity_impl!(RequestId, "request");

/// Position in [`Schedule::loops`](super::Schedule::loops).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LoopId(u32);
entity_impl!(LoopId, "loop");
