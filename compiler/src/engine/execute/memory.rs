//! What the executor works in.

use std::sync::atomic::{AtomicU64, Ordering};

use cranelift_entity::SecondaryMap;

use crate::engine::Evaluations;
use crate::engine::requests::Asking;
use crate::engine::runner::Runs;
use crate::engine::turns::Turning;
use crate::schedule::{LoopId, RegionId, Schedule};
use crate::specialise::{LightTableId, Specialised};
use crate::storage::{FileShape, LANES, Lanes};

/// What the executor works in; kept between batches.
#[derive(Debug, Default)]
pub struct Memory {
    pub(super) lanes: Vec<Lanes>,
    /// Whose uniform words lie there, if that is known.
    holds: Option<WordsId>,
    /// Per region and block, the lanes it is being run for.
    pub(super) todo: Vec<u8>,
    /// Per region and block, the lanes it was run for.
    pub(super) done: Vec<u8>,
    /// Per table and iteration, answers kept.
    pub(super) tables: SecondaryMap<LightTableId, Vec<Table>>,
    /// Per loop, its iteration.
    pub(super) iterations: SecondaryMap<LoopId, usize>,
    /// Per loop and point, the token of the light sample.
    pub(super) tokens: SecondaryMap<LoopId, Vec<u64>>,
    pub(super) runs: Runs,
    pub(super) tally: Tally,
    pub(super) stack: Vec<Frame>,
    pub(super) chosen: Vec<usize>,
    /// What requests and turns of loops work in; away while one does. In boxes, so that they come and go by pointer.
    pub(super) asking: Option<Box<Asking>>,
    pub(super) turning: Option<Box<Turning>>,
    /// Words of points, of what a loop takes.
    pub(super) values: Vec<u32>,
}

/// The uniform words of a program.
#[derive(Clone, Copy, Debug)]
pub struct UniformWords<'a> {
    /// The words.
    pub words: &'a [u32],
    /// Which words they are: nobody else's have this, and they never change. A call of a single point would
    /// spend its time writing them anew.
    pub id: Option<WordsId>,
}

/// What tells uniform words of one program, under one set of values, from all others of the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WordsId(u64);

impl WordsId {
    /// One that nobody has.
    pub fn unique() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// What is counted of a batch.
#[derive(Debug, Default)]
pub(super) struct Tally {
    /// Per instance and block, the lanes that want it and were not counted yet.
    pub(super) wanted: Vec<u8>,
    pub(super) counted: Evaluations,
}

impl Tally {
    /// Makes it ready for a batch.
    pub(super) fn fit(&mut self, graph: Option<&Specialised>, blocks: usize) {
        self.wanted.clear();
        self.wanted.resize(graph.map_or(0, |graph| graph.instances.len() * blocks), 0);
    }
}

/// Answers about one light sample.
#[derive(Clone, Debug, Default)]
pub(super) struct Table {
    /// Per block, the lanes whose answers are known.
    pub(super) known: Vec<u8>,
    /// Per point, the words of its answer.
    pub(super) words: Vec<u32>,
}

/// Where the executor goes on once what stands above is done.
#[derive(Clone, Copy, Debug)]
pub(super) enum Frame {
    Region { region: RegionId, item: usize },
    Loop { at: LoopId, within: RegionId, count: usize },
}

impl Memory {
    /// Makes room for a batch, with the uniform words in place.
    pub(super) fn fit(&mut self, uniforms: UniformWords<'_>, shape: FileShape, blocks: usize) {
        self.lanes.resize(shape.words(blocks).max(self.lanes.len()), Lanes::default());
        if uniforms.id.is_none() || self.holds != uniforms.id {
            for (lane, word) in self.lanes.iter_mut().zip(uniforms.words) {
                *lane = Lanes([*word; LANES]);
            }
            self.holds = uniforms.id;
        }
    }

    /// Forgets what was run for other points.
    pub(super) fn begin(&mut self, schedule: &Schedule, blocks: usize) {
        let masks = schedule.regions.len() * blocks;
        self.todo.clear();
        self.todo.resize(masks, 0);
        self.done.clear();
        self.done.resize(masks, 0);
        self.iterations.clear();
        self.tables.values_mut().for_each(|table| empty(table));
    }
}

/// Forgets the answers of a table.
pub(super) fn empty(table: &mut [Table]) {
    for sample in table {
        sample.known.fill(0);
    }
}
