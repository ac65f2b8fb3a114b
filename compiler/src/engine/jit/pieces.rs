//! A schedule cut into what the jit fuses and what it leaves to kernels, before any machine code.

use std::fmt;

use cranelift_entity::PrimaryMap;

use crate::ops::hoist::{Hoisted, Hoister};
use crate::ops::{OpSegment, dead, split, verify};
use crate::schedule::{Item, Loop, Request, Schedule, Segment, SegmentId};
use crate::storage::Source;

use super::Generator;
use super::recorder::Recorder;

/// Bodies of more operations run as kernels beside Cranelift's code: eight lanes beat four there. A kernel has a
/// price for each call, which few points share in a small batch.
const HEAVY_OPS: usize = 16;

/// The same where batches are smaller than [`SMALL_BATCH`].
const HEAVY_OPS_OF_FEW: usize = 96;

/// Bodies of more operations run as kernels beside native code, which beats them at any size: only so that a loop
/// over a count, unrolled here, does not become megabytes.
const HEAVY_OPS_OF_NATIVE: usize = 4096;

/// Batches of fewer points, two blocks, are small.
const SMALL_BATCH: usize = 16;

/// A schedule in pieces.
#[derive(Debug, Default)]
pub struct Pieces {
    /// Per segment, what to run in order.
    pub segments: PrimaryMap<SegmentId, Vec<Piece>>,
    /// The operations of what is fused.
    pub functions: Vec<OpSegment>,
    /// What of them is computed when parameters are bound.
    pub hoisted: Hoisted,
    /// Slots the functions need besides those of the schedule.
    pub scratch: u32,
}

/// What runs as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A function of the code.
    Fused(usize),
    /// A step of the segment, as a kernel.
    Kernel(usize),
}

/// Steps of a segment that run as one, by position.
#[derive(Clone, Copy)]
enum Stretch {
    Light { from: usize, to: usize },
    Heavy(usize),
}

impl Pieces {
    /// Cuts `schedule`, of a program of that many uniform words, for a generator, to be run over at most
    /// `batch` points at once. The words of `kept` are kept in the file, whoever reads them.
    pub fn of(
        schedule: &Schedule,
        uniforms: usize,
        batch: usize,
        generator: Generator,
        kept: &[Source],
    ) -> Self {
        let heavy = match generator {
            Generator::Native => HEAVY_OPS_OF_NATIVE,
            Generator::Cranelift if batch < SMALL_BATCH => HEAVY_OPS_OF_FEW,
            Generator::Cranelift => HEAVY_OPS,
        };
        let segments = schedule.segments.values();
        let stretches: Vec<_> = segments.map(|segment| stretches(segment, heavy)).collect();
        let readers = Readers::new(schedule, &stretches, kept);
        let mut pieces = Self::default();
        let mut recorder = Recorder::new(schedule.slots);
        let mut hoister = Hoister::new(uniforms as u32);
        let mut number = 0;
        for (segment, stretches) in schedule.segments.values().zip(&stretches) {
            let mut in_order = Vec::new();
            for stretch in stretches {
                match *stretch {
                    Stretch::Heavy(step) => in_order.push(Piece::Kernel(step)),
                    Stretch::Light { from, to } => {
                        let stored = |slot| readers.outside(slot, number);
                        let ops = recorder.record(&segment.steps[from..to], stored);
                        verify::after("record", || verify::legal(&ops));
                        let ops = dead::remove(&ops);
                        verify::after("dead", || verify::legal(&ops));
                        let ops = hoister.hoist(ops);
                        verify::after("hoist", || verify::legal(&ops));
                        let split = split::split(&ops, split::COMFORTABLE, schedule.slots);
                        verify::after("split", || {
                            verify::parts(&ops, &split.parts, schedule.slots)
                        });
                        // Scratch lives within one stretch, so all stretches share it.
                        pieces.scratch = pieces.scratch.max(split.scratch);
                        for part in split.parts {
                            in_order.push(Piece::Fused(pieces.functions.len()));
                            pieces.functions.push(part);
                        }
                    }
                }
                number += 1;
            }
            pieces.segments.push(in_order);
        }
        pieces.hoisted = hoister.finish();
        pieces
    }
}

impl fmt::Display for Pieces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.hoisted)?;
        for (at, segment) in &self.segments {
            writeln!(f, "segment {}:", at.as_u32())?;
            for piece in segment {
                match *piece {
                    Piece::Kernel(step) => writeln!(f, "kernel of step {step}")?,
                    Piece::Fused(function) => {
                        writeln!(f, "function {function}")?;
                        write!(f, "{}", self.functions[function])?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Cuts a segment at its heavy steps, of more operations than `heavy`, and where others want it.
fn stretches(segment: &Segment, heavy: usize) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    let mut from = 0;
    for (at, step) in segment.steps.iter().enumerate() {
        if from < at && segment.steps[from].wanted != step.wanted {
            stretches.push(Stretch::Light { from, to: at });
            from = at;
        }
        if step.code.recorded().weight() > heavy {
            if from < at {
                stretches.push(Stretch::Light { from, to: at });
            }
            stretches.push(Stretch::Heavy(at));
            from = at + 1;
        }
    }
    if from < segment.steps.len() {
        stretches.push(Stretch::Light { from, to: segment.steps.len() });
    }
    stretches
}

/// Per slot, who reads it.
struct Readers(Vec<Reader>);

#[derive(Clone, Copy, PartialEq)]
enum Reader {
    Nobody,
    /// One stretch, by its number over all segments.
    Stretch(usize),
    Several,
}

impl Readers {
    fn new(schedule: &Schedule, stretches: &[Vec<Stretch>], kept: &[Source]) -> Self {
        let mut readers = Self(vec![Reader::Nobody; schedule.slots as usize]);
        let mut number = 0;
        for (segment, stretches) in schedule.segments.values().zip(stretches) {
            for stretch in stretches {
                let steps = match *stretch {
                    Stretch::Light { from, to } => from..to,
                    Stretch::Heavy(step) => step..step + 1,
                };
                for step in &segment.steps[steps] {
                    readers.note(&step.words, Reader::Stretch(number));
                    // Asked before the stretch, so from the file.
                    readers.note(&step.wanted, Reader::Several);
                }
                number += 1;
            }
        }
        for region in schedule.regions.values() {
            for item in &region.items {
                if let Item::Force { guard: Some(guard), .. } = item {
                    readers.note(&[*guard], Reader::Several);
                }
            }
        }
        let requests = schedule.requests.values().flat_map(Request::reads);
        let loops = schedule.loops.values().flat_map(Loop::reads);
        requests.chain(loops).for_each(|word| readers.note(&[word], Reader::Several));
        let root: Vec<Source> = (schedule.root..schedule.root + 5).map(Source::Slot).collect();
        readers.note(&root, Reader::Several);
        readers.note(kept, Reader::Several);
        readers
    }

    fn note(&mut self, words: &[Source], reader: Reader) {
        for word in words {
            if let Source::Slot(slot) = word {
                let known = &mut self.0[*slot as usize];
                *known = match *known {
                    Reader::Nobody => reader,
                    same if same == reader => reader,
                    _ => Reader::Several,
                };
            }
        }
    }

    /// Whether anyone but the stretch of this number reads the slot.
    fn outside(&self, slot: u32, number: usize) -> bool {
        !matches!(self.0[slot as usize], Reader::Nobody)
            && self.0[slot as usize] != Reader::Stretch(number)
    }
}
