//! Which evaluations of nodes a batch wanted and made, where that is counted.
//!
//! What is wanted is found backwards once all is evaluated: users before what they demand, by the very
//! guards of their demands. So it is the count of the walk, whatever the schedule does. A turn of a loop is
//! settled before the next overwrites its words.

use cranelift_entity::EntityRef;

use crate::schedule::{Loop, RegionId, SegmentId};
use crate::specialise::{EpochId, Guard, InstanceId, InstanceKind, Specialised};
use crate::storage::LANES;

use super::memory::Memory;
use super::run::Run;

impl Run<'_> {
    /// Counts what a segment evaluated, once it was run.
    pub(super) fn count_segment(&mut self, at: SegmentId) {
        if self.program.counted.is_none() {
            return;
        }
        let Memory { lanes, runs, .. } = &*self.memory;
        let mut done = 0;
        for step in &self.program.schedule.segments[at].steps {
            if step.is_guard {
                continue;
            }
            done += runs.wanting(&step.wanted, self.shape, lanes).count() * LANES;
        }
        self.memory.tally.counted.done += done as u64;
    }

    /// Counts a request, or a loop, of the chosen points.
    pub(super) fn count_chosen(&mut self) {
        self.memory.tally.counted.done += self.memory.chosen.len() as u64;
    }

    /// Counts what all points wanted that belongs to no loop.
    pub(super) fn settle_points(&mut self) {
        if let Some(graph) = self.program.counted {
            self.want(graph.root(), RegionId::ROOT);
            self.settle(graph, EpochId::POINT);
        }
    }

    /// Counts what a turn of a loop wanted.
    pub(super) fn settle_turn(&mut self, of: &Loop) {
        let Some(graph) = self.program.counted else { return };
        let body = graph.instances.values().find_map(|instance| match instance.kind {
            InstanceKind::Loop { epoch, body, .. } if epoch == of.epoch => body,
            _ => None,
        });
        if let Some(body) = body {
            self.want(body, of.region);
        }
        self.settle(graph, of.epoch);
    }

    /// All points that a region is run for want an instance.
    fn want(&mut self, id: InstanceId, region: RegionId) {
        for block in 0..self.blocks {
            let mask = self.memory.todo[self.mask(region, block)];
            self.memory.tally.wanted[id.index() * self.blocks + block] |= mask;
        }
    }

    /// Counts what is wanted of the instances of a loop, or of none, and goes on to what they demand.
    fn settle(&mut self, graph: &Specialised, turns: EpochId) {
        for (id, instance) in graph.instances.iter().rev() {
            let own = graph.epochs.innermost_loop(instance.epoch).unwrap_or(EpochId::POINT);
            if own != turns {
                continue;
            }
            for block in 0..self.blocks {
                let wanted = &mut self.memory.tally.wanted[id.index() * self.blocks + block];
                let mask = std::mem::take(wanted);
                if mask == 0 {
                    continue;
                }
                self.memory.tally.counted.wanted += u64::from(mask.count_ones());
                for demand in &instance.demands {
                    let held = match &demand.guard {
                        Some(guard) => self.held(guard, block, mask),
                        None => mask,
                    };
                    let at = demand.source.index() * self.blocks + block;
                    self.memory.tally.wanted[at] |= held;
                }
            }
        }
    }

    /// The lanes of a mask for which a guard holds.
    fn held(&self, guard: &Guard, block: usize, mask: u8) -> u8 {
        let mut held = 0;
        for lane in (0..LANES).filter(|lane| mask >> lane & 1 == 1) {
            let point = block * LANES + lane;
            let words: Vec<u32> = guard.words.iter().map(|word| self.word(*word, point)).collect();
            let mut outcome = [0];
            guard.code.scalar_portable(&words, &mut outcome);
            held |= u8::from(outcome[0] != 0) << lane;
        }
        held
    }
}
