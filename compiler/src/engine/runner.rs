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

    /// Runs a segment of the schedule over the blocks of a file. `runs` is working memory.
    pub fn segment(
        &self,
        schedule: &Schedule,
        segment: SegmentId,
        shape: FileShape,
        lanes: &mut [Lanes],
        blocks: usize,
        runs: &mut Runs,
    ) {
        let steps = &schedule.segments[segment].steps;
        runs.forget();
        match self {
            Runner::Kernels(simd) => {
                for step in steps {
                    runs.find(&step.wanted, shape, lanes, blocks);
                    run_step(step, *simd, shape, lanes, runs);
                }
            }
            Runner::Jit(plan) => {
                plan.run(segment, lanes, blocks, |step, simd, lanes| {
                    runs.find(&steps[step].wanted, shape, lanes, blocks);
                    run_step(&steps[step], simd, shape, lanes, runs);
                });
            }
        }
    }
}

/// Runs the kernel of one step.
fn run_step(step: &Step, simd: Simd, shape: FileShape, lanes: &mut [Lanes], runs: &Runs) {
    for run in &runs.runs {
        let (first, blocks) = (run.start, run.len());
        let placement =
            Placement { shape, first, blocks, sources: &step.words, output: step.output };
        match simd {
            Simd::Native => step.code.wide(lanes, &placement),
            Simd::Portable => step.code.wide_portable(lanes, &placement),
        }
    }
}

/// Blocks next to one another in which some point wants something.
#[derive(Debug, Default)]
pub struct Runs {
    /// The masks that were asked last; kept between segments, so that nothing is allocated.
    of: Vec<Source>,
    /// Whether they still say what they said.
    are_asked: bool,
    runs: Vec<Range<usize>>,
}

impl Runs {
    /// Masks may have changed.
    fn forget(&mut self) {
        self.are_asked = false;
    }

    /// Finds the blocks in which a point holds all of these masks; all blocks if there are none. Masks
    /// that were asked last are not asked again: what is skipped by them does not write them.
    fn find(&mut self, wanted: &[Source], shape: FileShape, lanes: &[Lanes], blocks: usize) {
        if self.are_asked && self.of == wanted {
            return;
        }
        self.are_asked = true;
        self.of.clear();
        self.of.extend_from_slice(wanted);
        self.runs.clear();
        if wanted.is_empty() {
            return self.runs.push(0..blocks);
        }
        for block in (0..blocks).filter(|&block| is_wanted(wanted, shape, lanes, block)) {
            match self.runs.last_mut().filter(|last| last.end == block) {
                Some(last) => last.end += 1,
                None => self.runs.push(block..block + 1),
            }
        }
    }
}

/// Whether some lane of a block holds all of these masks.
pub fn is_wanted(wanted: &[Source], shape: FileShape, lanes: &[Lanes], block: usize) -> bool {
    let mut all = [u32::MAX; LANES];
    for &mask in wanted {
        let words = &lanes[shape.at(mask, block)].0;
        all.iter_mut().zip(words).for_each(|(all, word)| *all &= word);
    }
    all != [0; LANES]
}
