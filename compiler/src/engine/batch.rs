//! How segments are run: kernel by kernel, or as the jit planned.

use crate::schedule::Segment;

use super::Simd;
use super::execute::Program;
use crate::storage::{Lanes, Placement};

/// How segments are run.
#[derive(Clone, Copy)]
pub enum Runner<'a> {
    /// The kernel of each step, over all blocks.
    Kernels(Simd),
    /// Machine code for light steps, kernels for heavy ones.
    Jit(&'a super::jit::Plan),
}

impl Runner<'_> {
    /// Runs a segment of the program over the blocks.
    pub fn segment(
        &self,
        program: &Program<'_>,
        segment: usize,
        lanes: &mut [Lanes],
        blocks: usize,
    ) {
        match self {
            Runner::Kernels(simd) => {
                let segment = &program.schedule.segments[segment];
                run_kernels(segment, *simd, program, lanes, blocks);
            }
            Runner::Jit(plan) => plan.run(segment, program, lanes, blocks),
        }
    }
}

fn run_kernels(
    segment: &Segment,
    simd: Simd,
    program: &Program<'_>,
    lanes: &mut [Lanes],
    blocks: usize,
) {
    for step in &segment.steps {
        run_step(step, simd, program, lanes, blocks);
    }
}

/// Runs the kernel of one step.
pub(super) fn run_step(
    step: &crate::schedule::Step,
    simd: Simd,
    program: &Program<'_>,
    lanes: &mut [Lanes],
    blocks: usize,
) {
    let placement = Placement {
        uniforms: program.uniforms.len(),
        slots: program.slots,
        blocks,
        sources: &step.words,
        output: step.output,
    };
    match simd {
        Simd::Native => (step.code.wide)(lanes, &placement),
        Simd::Portable => (step.code.wide_portable)(lanes, &placement),
    }
}
