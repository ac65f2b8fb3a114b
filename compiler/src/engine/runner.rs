//! How segments are run: kernel by kernel, or as the jit planned.

use crate::schedule::{Schedule, SegmentId, Step};
use crate::storage::{FileShape, Lanes, Placement, stride};

use super::jit::Plan;
use super::options::Simd;

/// How segments are run.
#[derive(Clone, Copy)]
pub enum Runner<'a> {
    /// The kernel of each step, over all blocks.
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

    /// Runs a segment of the schedule over the blocks of a file.
    pub fn segment(
        &self,
        schedule: &Schedule,
        segment: SegmentId,
        shape: FileShape,
        lanes: &mut [Lanes],
        blocks: usize,
    ) {
        let steps = &schedule.segments[segment].steps;
        match self {
            Runner::Kernels(simd) => {
                steps.iter().for_each(|step| run_step(step, *simd, shape, lanes, blocks));
            }
            Runner::Jit(plan) => {
                plan.run(segment, lanes, blocks, |step, simd, lanes| {
                    run_step(&steps[step], simd, shape, lanes, blocks);
                });
            }
        }
    }
}

/// Runs the kernel of one step.
fn run_step(step: &Step, simd: Simd, shape: FileShape, lanes: &mut [Lanes], blocks: usize) {
    let placement = Placement { shape, blocks, sources: &step.words, output: step.output };
    match simd {
        Simd::Native => step.code.wide(lanes, &placement),
        Simd::Portable => step.code.wide_portable(lanes, &placement),
    }
}
