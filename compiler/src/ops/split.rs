//! Cutting of a long segment into parts that are compiled as functions of their own and run one
//! after another, each over all blocks.
//!
//! A turn of a short loop is overlapped by the CPU with the next; one longer than its reorder window
//! waits for its own chain of dependent operations. So cutting pays long before register allocation,
//! which is quadratic on huge functions, asks for it: 893 operations in one chain took 107 ns per
//! point in parts of 500, and 59 in parts of 80, at any batch from 8 to 256 in about this ratio.
//!
//! A value needed past a cut is stored to a scratch slot at the end of its part and loaded where
//! it is needed; constants and loads are repeated instead.

use super::{Op, OpId, OpSegment};
use crate::storage::Source;

/// Operations of a part that run well.
pub const COMFORTABLE: usize = 80;

/// A segment in parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Split {
    /// To be run in order, for all blocks each.
    pub parts: Vec<OpSegment>,
    /// Scratch slots used, from the first free one on.
    pub scratch: u32,
}

/// Cuts `segment` into parts of about `limit` operations (loads and constants not counted), using
/// slots from `first_free` on. A cut is made where few values cross it.
pub fn split(segment: &OpSegment, limit: usize, first_free: u32) -> Split {
    let ends = cuts(segment, limit.max(1));
    if ends.len() <= 1 {
        return Split { parts: vec![segment.clone()], scratch: 0 };
    }
    Splitter::new(segment, &ends, first_free).run()
}

/// Where parts end: positions behind their last operation.
fn cuts(segment: &OpSegment, limit: usize) -> Vec<usize> {
    let crossing = crossing(segment);
    let mut ends = Vec::new();
    let mut start = 0;
    while start < segment.ops.len() {
        let mut work = 0;
        let mut best = None;
        let mut end = start;
        while end < segment.ops.len() && work < limit {
            work += usize::from(!segment.ops[end].is_fetch());
            end += 1;
            // Late cuts are preferred among equals: fewer parts.
            let late_enough = work * 4 >= limit * 3;
            if late_enough && best.is_none_or(|(fewest, _)| crossing[end] <= fewest) {
                best = Some((crossing[end], end));
            }
        }
        let rest_has_work = segment.ops[end..].iter().any(|op| !op.is_fetch());
        start = match best {
            Some((_, at)) if rest_has_work => at,
            _ => segment.ops.len(),
        };
        ends.push(start);
    }
    ends
}

/// For every position, how many values computed before it are used at or behind it.
fn crossing(segment: &OpSegment) -> Vec<usize> {
    let mut last_use = vec![0; segment.ops.len()];
    for (id, op) in segment.ops.iter().enumerate() {
        op.for_each_operand(|operand| last_use[operand as usize] = id);
    }
    let mut change = vec![0isize; segment.ops.len() + 2];
    for (id, op) in segment.ops.iter().enumerate() {
        if !op.is_fetch() && last_use[id] > id {
            change[id + 1] += 1;
            change[last_use[id] + 1] -= 1;
        }
    }
    let mut live = 0;
    change[..=segment.ops.len()]
        .iter()
        .map(|change| {
            live += change;
            live as usize
        })
        .collect()
}

struct Splitter<'a> {
    segment: &'a OpSegment,
    ends: &'a [usize],
    /// The part each operation is computed in.
    home: Vec<usize>,
    /// Slots the segment reads, in order.
    read: Vec<u32>,
    /// The stores each part performs.
    stores: Vec<Vec<(u32, OpId)>>,
    /// The last part that needs it.
    last: Vec<usize>,
    /// The scratch slot that keeps it, once its part is done.
    kept: Vec<Option<u32>>,
    free: Vec<u32>,
    first_free: u32,
    scratch: u32,
}

impl<'a> Splitter<'a> {
    fn new(segment: &'a OpSegment, ends: &'a [usize], first_free: u32) -> Self {
        let mut home = Vec::with_capacity(segment.ops.len());
        for (part, &end) in ends.iter().enumerate() {
            home.resize(end, part);
        }
        let mut last = home.clone();
        for (id, op) in segment.ops.iter().enumerate() {
            op.for_each_operand(|operand| {
                let last = &mut last[operand as usize];
                *last = home[id].max(*last);
            });
        }
        let read = segment.sources.iter().filter_map(|source| match source {
            Source::Slot(slot) => Some(*slot),
            Source::Uniform(_) | Source::Constant { .. } => None,
        });
        let mut read: Vec<u32> = read.collect();
        read.sort_unstable();
        let splitter = Self {
            segment,
            read,
            stores: vec![Vec::new(); ends.len()],
            ends,
            home,
            last,
            kept: vec![None; segment.ops.len()],
            free: Vec::new(),
            first_free,
            scratch: 0,
        };
        splitter.with_late_stores()
    }

    /// The part that performs a store: where its value is computed, or the last one if the slot
    /// is also read, so that every load still comes before.
    fn store_part(&self, slot: u32, id: OpId) -> usize {
        let is_read = self.read.binary_search(&slot).is_ok();
        if is_read { self.ends.len() - 1 } else { self.home[id as usize] }
    }

    fn with_late_stores(mut self) -> Self {
        for &(slot, id) in &self.segment.stores {
            let part = self.store_part(slot, id);
            let last = &mut self.last[id as usize];
            *last = part.max(*last);
            self.stores[part].push((slot, id));
        }
        self
    }

    fn run(mut self) -> Split {
        let crossing = self.crossing();
        let mut crossing = crossing.as_slice();
        let mut writer = Writer::new(self.segment);
        let mut parts = Vec::with_capacity(self.ends.len());
        for part in 0..self.ends.len() {
            parts.push(self.part(part, &mut writer));
            let after = crossing.partition_point(|&id| self.last[id] <= part);
            let (done, rest) = crossing.split_at(after);
            done.iter().for_each(|&id| self.free.extend(self.kept[id]));
            crossing = rest;
        }
        Split { parts, scratch: self.scratch }
    }

    /// What is needed past the part it is computed in, in the order in which it is no longer needed.
    fn crossing(&self) -> Vec<usize> {
        let ids = 0..self.segment.ops.len();
        let mut crossing: Vec<usize> = ids.filter(|&id| self.last[id] > self.home[id]).collect();
        crossing.sort_by_key(|&id| self.last[id]);
        crossing
    }

    fn part(&mut self, part: usize, writer: &mut Writer) -> OpSegment {
        let start = if part == 0 { 0 } else { self.ends[part - 1] };
        let end = self.ends[part];
        writer.start(part);
        // Blocks are wanted by all parts or by none.
        writer.segment.wanted.clone_from(&self.segment.wanted);
        for id in start..end {
            // Fetches are repeated where they are used.
            let op = self.segment.ops[id];
            if !op.is_fetch() {
                let op = op.map_operands(|operand| self.operand(writer, operand));
                writer.push(id as OpId, op);
            }
        }
        for &(slot, id) in &self.stores[part] {
            let id = self.operand(writer, id);
            writer.segment.stores.push((slot, id));
        }
        // Slots are given back only after those of this part are taken: within a part no slot is
        // both read and written.
        for id in start..end {
            if self.last[id] > part && !self.segment.ops[id].is_fetch() {
                let slot = self.take();
                self.kept[id] = Some(slot);
                let id = self.operand(writer, id as OpId);
                writer.segment.stores.push((slot, id));
            }
        }
        std::mem::take(&mut writer.segment)
    }

    fn take(&mut self) -> u32 {
        self.free.pop().unwrap_or_else(|| {
            self.scratch += 1;
            self.first_free + self.scratch - 1
        })
    }

    /// The operation in the part being written that has the word of `id`.
    fn operand(&self, writer: &mut Writer, id: OpId) -> OpId {
        if let Some(known) = writer.known(id) {
            return known;
        }
        let op = match (self.segment.ops[id as usize], self.kept[id as usize]) {
            (Op::Load(source), _) => writer.load(source, self.segment.sources[source as usize]),
            (_, Some(slot)) => writer.load_slot(slot),
            (op, None) => op,
        };
        writer.push(id, op)
    }
}

/// A part being written. What it knows of the whole is kept from part to part, with the part it is true
/// of.
struct Writer {
    segment: OpSegment,
    part: usize,
    /// Operations of the part by operations of the whole.
    known: Vec<(usize, OpId)>,
    /// Sources of the part by sources of the whole.
    sources: Vec<(usize, u32)>,
}

/// Of no part.
const NEVER: (usize, u32) = (usize::MAX, 0);

impl Writer {
    fn new(whole: &OpSegment) -> Self {
        Self {
            segment: OpSegment::default(),
            part: 0,
            known: vec![NEVER; whole.ops.len()],
            sources: vec![NEVER; whole.sources.len()],
        }
    }

    fn start(&mut self, part: usize) {
        self.part = part;
    }

    fn known(&self, whole: OpId) -> Option<OpId> {
        let (part, id) = self.known[whole as usize];
        (part == self.part).then_some(id)
    }

    fn push(&mut self, whole: OpId, op: Op) -> OpId {
        let id = self.segment.ops.len() as OpId;
        self.segment.ops.push(op);
        self.known[whole as usize] = (self.part, id);
        id
    }

    fn load(&mut self, whole: u32, source: Source) -> Op {
        let known = &mut self.sources[whole as usize];
        if known.0 != self.part {
            self.segment.sources.push(source);
            *known = (self.part, self.segment.sources.len() as u32 - 1);
        }
        Op::Load(known.1)
    }

    /// Loads what an earlier part kept; once in a part, for the operation is known then.
    fn load_slot(&mut self, slot: u32) -> Op {
        self.segment.sources.push(Source::Slot(slot));
        Op::Load(self.segment.sources.len() as u32 - 1)
    }
}
