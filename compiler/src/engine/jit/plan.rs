//! The jit's plan: the pieces of a schedule, with the machine code of those that are fused.

use cranelift_entity::PrimaryMap;

use crate::engine::options::Simd;
use crate::schedule::{Schedule, SegmentId};
use crate::storage::{FileShape, Lanes, stride};

use super::pieces::{Piece, Pieces};
use super::{JitCode, JitError};

/// The jit's plan for a schedule, with its code.
#[derive(Debug)]
pub struct Plan {
    /// Per segment, what to run in order.
    segments: PrimaryMap<SegmentId, Vec<Piece>>,
    code: JitCode,
    simd: Simd,
    slots: usize,
}

impl Plan {
    /// Plans and compiles `schedule` for a program of that many uniform words, to run over at most
    /// `batch` points at once.
    pub fn new(
        schedule: &Schedule,
        uniforms: usize,
        simd: Simd,
        batch: usize,
    ) -> Result<Self, JitError> {
        let Pieces { segments, functions, scratch } = Pieces::of(schedule, batch);
        let slots = stride(schedule.slots + scratch);
        let code = JitCode::compile(&functions, FileShape { uniforms, slots })?;
        Ok(Self { segments, code, simd, slots })
    }

    /// Slots of a block, scratch included.
    pub fn slots(&self) -> usize {
        self.slots
    }

    /// Bytes of machine code.
    pub fn code_bytes(&self) -> usize {
        self.code.code_bytes()
    }

    /// Runs a segment over the blocks; `kernel` runs those of its steps that are kernels.
    pub(in crate::engine) fn run(
        &self,
        segment: SegmentId,
        lanes: &mut [Lanes],
        blocks: usize,
        kernel: impl Fn(usize, Simd, &mut [Lanes]),
    ) {
        for piece in &self.segments[segment] {
            match *piece {
                Piece::Fused(function) => self.code.run(function, lanes, blocks),
                Piece::Kernel(step) => kernel(step, self.simd, lanes),
            }
        }
    }
}
