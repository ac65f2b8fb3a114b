//! The jit's plan: the pieces of a schedule, with the machine code of those that are fused.

use std::ops::Range;
use std::sync::Arc;

use cranelift_entity::PrimaryMap;

use crate::engine::options::Simd;
use crate::ops::OpSegment;
use crate::ops::hoist::Hoisted;
use crate::schedule::{Schedule, SegmentId};
use crate::storage::{FileShape, Lanes, Source, stride};

use super::layout::{Layout, lay_out};
use super::pieces::{Piece, Pieces};
use super::shared::{Pool, Shared};
use super::{Generator, JitCode, JitError};

/// All that code is made from.
#[derive(Debug, PartialEq, Eq, Hash)]
struct Asked {
    generator: Generator,
    functions: Vec<OpSegment>,
    shape: FileShape,
}

/// The code of all plans of the process: graphs of the same operations share it.
static CODE: Pool<Asked, JitCode> = Pool::new();

/// The jit's plan for a schedule, with its code.
#[derive(Debug)]
pub struct Plan {
    /// Per segment, what to run in order.
    segments: PrimaryMap<SegmentId, Vec<Part>>,
    code: Arc<Shared<Asked, JitCode>>,
    hoisted: Hoisted,
    layout: Option<Layout>,
    simd: Simd,
    slots: usize,
}

/// What runs as one.
#[derive(Clone, Debug)]
enum Part {
    /// Functions of the code, block by block.
    Functions(Range<usize>),
    /// A step of the segment, as a kernel.
    Kernel(usize),
}

impl Plan {
    /// Plans and compiles `schedule` for a program of that many uniform words, to run over at most
    /// `batch` points at once. Where words are `kept`, for somebody besides the schedule to read, all have the places
    /// in the file that the schedule gives them; else only what is read lies there.
    pub fn new(
        schedule: &Schedule,
        uniforms: usize,
        simd: Simd,
        batch: usize,
        generator: Generator,
        kept: Option<&[Source]>,
    ) -> Result<Self, JitError> {
        let mut pieces = Pieces::of(schedule, uniforms, batch, generator, kept.unwrap_or_default());
        let layout = kept.is_none().then(|| lay_out(schedule, &mut pieces));
        let Pieces { segments, functions, hoisted, scratch } = pieces;
        let (words, slots) = match &layout {
            Some(layout) => (layout.uniforms.len(), layout.schedule.slots),
            None => (uniforms + hoisted.words(), schedule.slots + scratch),
        };
        let slots = stride(slots);
        let shape = FileShape { uniforms: words, slots };
        let compile = |asked: &Asked| JitCode::compile(generator, &asked.functions, asked.shape);
        let code = CODE.get_or_make(Asked { generator, functions, shape }, compile)?;
        let segments = segments.values().map(|pieces| joined(pieces)).collect();
        Ok(Self { segments, code, hoisted, layout, simd, slots })
    }

    /// The uniform words of the file, from those of the program. To be computed anew whenever one of them
    /// changes.
    pub fn uniform_words(&self, uniforms: &[u32]) -> Vec<u32> {
        let all = self.hoisted.with_words(uniforms);
        match &self.layout {
            Some(layout) => layout.uniforms.iter().map(|&at| all[at]).collect(),
            None => all,
        }
    }

    /// The schedule it was made for, with words where they lie in the file.
    pub fn schedule<'a>(&'a self, schedule: &'a Schedule) -> &'a Schedule {
        self.layout.as_ref().map_or(schedule, |layout| &layout.schedule)
    }

    /// Slots of a block, scratch included.
    pub fn slots(&self) -> usize {
        self.slots
    }

    /// Bytes of machine code.
    pub fn code_bytes(&self) -> usize {
        self.code.code_bytes()
    }

    /// Whether both run the same machine code, not only equal one.
    pub fn shares_code_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.code, &other.code)
    }

    /// Runs a segment over runs of blocks; `kernel` runs those of its steps that are kernels.
    pub(in crate::engine) fn run(
        &self,
        segment: SegmentId,
        lanes: &mut [Lanes],
        used: &[Range<usize>],
        mut kernel: impl FnMut(usize, Simd, &mut [Lanes]),
    ) {
        for part in &self.segments[segment] {
            match part {
                Part::Functions(functions) => {
                    for run in used {
                        self.code.run(functions.clone(), lanes, run.clone());
                    }
                }
                Part::Kernel(step) => kernel(*step, self.simd, lanes),
            }
        }
    }
}

/// Pieces, with functions that follow one another as one part.
fn joined(pieces: &[Piece]) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for piece in pieces {
        match (*piece, parts.last_mut()) {
            (Piece::Fused(function), Some(Part::Functions(functions))) => {
                functions.end = function + 1;
            }
            (Piece::Fused(function), _) => parts.push(Part::Functions(function..function + 1)),
            (Piece::Kernel(step), _) => parts.push(Part::Kernel(step)),
        }
    }
    parts
}
