//! What a request needs while it runs.

use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::state::State;

use super::points::Waiting;
use crate::bvh::PrimitiveId;
use crate::geometry::RawHit;
use crate::lights::LightSource;

/// Scratch space of one request.
#[derive(Default)]
pub(super) struct Scratch {
    pub(super) waiting: Vec<Waiting>,
    pub(super) missed: Vec<(u32, [f32; 3])>,
    pub(super) states: Vec<State>,
    pub(super) results: Vec<Shaded>,
    pub(super) occluders: Vec<Occluder>,
    pub(super) found: Vec<Occluder>,
    pub(super) ranges: Vec<(u32, u32, u32)>,
    /// Of each point, where the light comes from.
    pub(super) sources: Vec<LightSource>,
}

/// Something between a point and a light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Occluder {
    pub(super) hit: RawHit,
    pub(super) id: PrimitiveId,
    pub(super) material: u32,
    /// Position of the point.
    pub(super) point: u32,
}
