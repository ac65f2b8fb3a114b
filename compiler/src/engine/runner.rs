//! How segments are run: kernel by kernel, or as the jit planned.

use std::ops::Range;

use crate::schedule::{Schedule, SegmentId, Step};
use crate::storage::{FileShape, LANES, Lanes, Placement, Source, stride};

use super::jit::Plan;
use super::options::Simd;

/// How segments are run.
#[derive(Clone, Copy)]
pub enum Runner<'a> {
    /// The kernel of each step, over all blocks in which some point wants it.
    Kernels(Simd),
    /// Machine code for light steps, kernels for heavy ones.
    Jit(&'a Plan),
}

impl Runner<'_> {
    /// Slots of a block of a file for `schedule`: the schedule's, and what the runner needs besides.
    pub fn slots(&self, schedule: &Schedule) -> usize {
        match self {
            Runner::Kernels(_) => stride(schedule.slots),
            Runner::Jit(plan) => plan.slots(),
        }
    }

    /// Runs a segment of the schedule over the blocks of a file in which some point is run.
    pub fn segment(
        &self,
        schedule: &Schedule,
        segment: SegmentId,
        shape: FileShape,
        lanes: &mut [Lanes],
        runs: &mut Runs,
    ) {
        let steps = &schedule.segments[segment].steps;
        let Runs { used, wanted } = runs;
        // Masks may have changed.
        wanted.is_known = false;
        match self {
            Runner::Kernels(simd) => {
                for step in steps {
                    wanted.find(&step.wanted, shape, lanes, used);
                    run_step(step, *simd, shape, lanes, &wanted.runs);
                }
            }
            Runner::Jit(plan) => {
                plan.run(segment, lanes, used, |step, simd, lanes| {
                    wanted.find(&steps[step].wanted, shape, lanes, used);
                    run_step(&steps[step], simd, shape, lanes, &wanted.runs);
                });
            }
        }
    }
}

/// Runs the kernel of one step.
fn run_step(step: &Step, simd: Simd, shape: FileShape, lanes: &mut [Lanes], runs: &[Range<usize>]) {
    for run in runs {
        let (first, blocks) = (run.start, run.len());
        let placement =
            Placement { shape, first, blocks, sources: &step.words, output: step.output };
        match simd {
            Simd::Native => step.code.wide(lanes, &placement),
            Simd::Portable => step.code.wide_portable(lanes, &placement),
        }
    }
}

/// Which blocks are run, as runs of blocks next to one another; kept so that nothing is allocated.
#[derive(Debug, Default)]
pub struct Runs {
    /// Those in which some point is run.
    used: Vec<Range<usize>>,
    wanted: Wanted,
}

/// Those of them in which some point wants a step.
#[derive(Debug, Default)]
struct Wanted {
    /// The masks that were asked last, if that still holds.
    of: Vec<Source>,
    is_known: bool,
    runs: Vec<Range<usize>>,
}

impl Runs {
    /// Takes the blocks with lanes in these masks.
    pub fn of(&mut self, masks: &[u8]) {
        self.used.clear();
        for (block, _) in masks.iter().enumerate().filter(|(_, mask)| **mask != 0) {
            append(&mut self.used, block);
        }
    }

    /// Takes the first blocks, so many.
    pub fn all(&mut self, blocks: usize) {
        self.used.clear();
        self.used.push(0..blocks);
    }

    /// The blocks in which some point is run and holds all of these masks.
    pub fn wanting(
        &self,
        wanted: &[Source],
        shape: FileShape,
        lanes: &[Lanes],
    ) -> impl Iterator<Item = usize> {
        let used = self.used.iter().flat_map(Range::clone);
        used.filter(move |&block| is_wanted(wanted, shape, lanes, block))
    }
}

impl Wanted {
    /// Finds the blocks, of those used, in which a point holds all of these masks. Masks that were asked
    /// last are not asked again: what is skipped by them does not write them.
    fn find(
        &mut self,
        wanted: &[Source],
        shape: FileShape,
        lanes: &[Lanes],
        used: &[Range<usize>],
    ) {
        if self.is_known && self.of == wanted {
            return;
        }
        self.is_known = true;
        self.of.clear();
        self.of.extend_from_slice(wanted);
        self.runs.clear();
        if wanted.is_empty() {
            return self.runs.extend_from_slice(used);
        }
        let used = used.iter().flat_map(Range::clone);
        for block in used.filter(|&block| is_wanted(wanted, shape, lanes, block)) {
            append(&mut self.runs, block);
        }
    }
}

/// Puts a block behind runs of blocks.
fn append(runs: &mut Vec<Range<usize>>, block: usize) {
    match runs.last_mut().filter(|last| last.end == block) {
        Some(last) => last.end += 1,
        None => runs.push(block..block + 1),
    }
}

/// Whether some lane of a block holds all of these masks.
fn is_wanted(wanted: &[Source], shape: FileShape, lanes: &[Lanes], block: usize) -> bool {
    let mut all = [u32::MAX; LANES];
    for &mask in wanted {
        let words = &lanes[shape.at(mask, block)].0;
        all.iter_mut().zip(words).for_each(|(all, word)| *all &= word);
    }
    all != [0; LANES]
}
