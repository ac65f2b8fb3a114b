//! The file of a plan: once steps are fused, most words of a schedule are read by nobody, and have no place in it.
//!
//! The words that are left stand side by side, in their order. Blocks are a fraction as long, so that more of them are in
//! the cache, and graphs that compute the same in more or fewer nodes have the same code.

use cranelift_entity::PrimaryMap;

use crate::ops::{OpSegment, verify};
use crate::schedule::{Item, Loop, Request, Schedule, Segment, Step};
use crate::specialise::{Context, Turns};
use crate::state::Iterated;
use crate::storage::Source;

use super::pieces::{Piece, Pieces};

/// What a plan keeps of a schedule: all but the steps that are fused, words by their places in its own file.
#[derive(Debug)]
pub struct Layout {
    /// The schedule. Its segments have the steps that stay kernels; its slots are those of the file, scratch included.
    pub schedule: Schedule,
    /// Which uniform words, those computed from others included, lie in the file.
    pub uniforms: Vec<usize>,
}

/// Lays out the file for a schedule in pieces, whose functions and kernels are made to use it.
pub fn lay_out(schedule: &Schedule, pieces: &mut Pieces) -> Layout {
    let used = Used::of(schedule, pieces);
    let places = used.places();
    for function in &mut pieces.functions {
        function.sources.iter_mut().for_each(|source| *source = places.source(*source));
        function.wanted.iter_mut().for_each(|source| *source = places.source(*source));
        function.stores.iter_mut().for_each(|(slot, _)| *slot = places.slot(*slot));
    }
    verify::after("layout", || pieces.functions.iter().try_for_each(verify::legal));
    let mut segments = PrimaryMap::with_capacity(schedule.segments.len());
    for (segment, pieces) in schedule.segments.values().zip(pieces.segments.values_mut()) {
        segments.push(kernels(segment, pieces, &places));
    }
    let field = |&(field, first): &(_, u32)| {
        used.slots[first as usize].then(|| (field, places.slot(first)))
    };
    let schedule = Schedule {
        regions: schedule
            .regions
            .values()
            .cloned()
            .map(|mut region| {
                for item in &mut region.items {
                    if let Item::Force { guard: Some(guard), .. } = item {
                        *guard = places.source(*guard);
                    }
                }
                region
            })
            .collect(),
        segments,
        requests: schedule
            .requests
            .values()
            .map(|request| placed_request(request, &places))
            .collect(),
        loops: schedule.loops.values().map(|of| placed_loop(of, &places)).collect(),
        fields: schedule.fields.iter().filter_map(field).collect(),
        slots: places.slot(used.slots.len() as u32),
        root: places.slot(schedule.root),
        tables: schedule.tables.clone(),
    };
    let uniforms = used.uniforms.iter().enumerate().filter(|(_, used)| **used);
    Layout { schedule, uniforms: uniforms.map(|(at, _)| at).collect() }
}

/// The steps of a segment that stay kernels, which its pieces name by their new positions.
fn kernels(segment: &Segment, pieces: &mut [Piece], places: &Places) -> Segment {
    let mut steps = Vec::new();
    for piece in pieces {
        if let Piece::Kernel(at) = piece {
            let step = &segment.steps[*at];
            *at = steps.len();
            steps.push(Step {
                words: places.sources(&step.words),
                output: places.slot(step.output),
                wanted: places.sources(&step.wanted),
                ..step.clone()
            });
        }
    }
    Segment { steps }
}

fn placed_request(request: &Request, places: &Places) -> Request {
    Request {
        words: places.sources(&request.words),
        output: places.slot(request.output),
        context: places.context(&request.context),
        ..request.clone()
    }
}

fn placed_loop(of: &Loop, places: &Places) -> Loop {
    let mut turns = of.turns.clone();
    if let Turns::Samples { count, .. } = &mut turns {
        *count = places.source(*count);
    }
    Loop {
        turns,
        fields: places.slot(of.fields),
        words: places.sources(&of.words),
        output: places.slot(of.output),
        context: places.context(&of.context),
        ..of.clone()
    }
}

/// The words that somebody reads or writes.
#[derive(Default)]
struct Used {
    slots: Vec<bool>,
    uniforms: Vec<bool>,
}

impl Used {
    fn of(schedule: &Schedule, pieces: &Pieces) -> Self {
        let mut used = Self {
            slots: vec![false; (schedule.slots + pieces.scratch) as usize],
            ..Self::default()
        };
        for OpSegment { sources, stores, wanted, .. } in &pieces.functions {
            used.words(sources);
            used.words(wanted);
            stores.iter().for_each(|&(slot, _)| used.slots(slot, 1));
        }
        for (segment, pieces) in schedule.segments.values().zip(pieces.segments.values()) {
            for piece in pieces {
                if let Piece::Kernel(step) = *piece {
                    let step = &segment.steps[step];
                    used.words(&step.words);
                    used.words(&step.wanted);
                    used.slots(step.output, step.code.outputs() as u32);
                }
            }
        }
        for item in schedule.regions.values().flat_map(|region| &region.items) {
            if let Item::Force { guard: Some(guard), .. } = item {
                used.words(&[*guard]);
            }
        }
        for request in schedule.requests.values() {
            request.reads().for_each(|word| used.words(&[word]));
            used.slots(request.output, request.outputs);
        }
        for of in schedule.loops.values() {
            of.reads().for_each(|word| used.words(&[word]));
            used.slots(of.output, of.value_type.width() as u32);
            let iterated = match of.turns {
                Turns::Lights { .. } => Iterated::Lights,
                Turns::Samples { .. } => Iterated::Samples,
            };
            used.slots(of.fields, iterated.words() as u32);
        }
        used.slots(schedule.root, 5);
        // A field is written as a whole, if anything of it is read.
        for &(field, first) in &schedule.fields {
            let width = field.value_type().width();
            if used.slots[first as usize..][..width].contains(&true) {
                used.slots(first, width as u32);
            }
        }
        used
    }

    fn words(&mut self, words: &[Source]) {
        for word in words {
            match *word {
                Source::Slot(slot) => self.slots[slot as usize] = true,
                Source::Uniform(at) | Source::Constant { at, .. } => {
                    let at = at as usize;
                    self.uniforms.resize(self.uniforms.len().max(at + 1), false);
                    self.uniforms[at] = true;
                }
            }
        }
    }

    fn slots(&mut self, first: u32, count: u32) {
        self.slots[first as usize..][..count as usize].fill(true);
    }

    fn places(&self) -> Places {
        Places { slots: numbered(&self.slots), uniforms: numbered(&self.uniforms) }
    }
}

/// How many are set before each, and at the end how many in all.
fn numbered(used: &[bool]) -> Vec<u32> {
    let mut before = 0;
    let numbers = used.iter().map(|used| {
        let number = before;
        before += u32::from(*used);
        number
    });
    let mut numbers: Vec<u32> = numbers.collect();
    numbers.push(before);
    numbers
}

/// Where each word of the schedule is in the file, if it is.
struct Places {
    slots: Vec<u32>,
    uniforms: Vec<u32>,
}

impl Places {
    fn slot(&self, slot: u32) -> u32 {
        self.slots[slot as usize]
    }

    fn source(&self, source: Source) -> Source {
        let uniform = |at: u32| self.uniforms[at as usize];
        match source {
            Source::Slot(slot) => Source::Slot(self.slot(slot)),
            Source::Uniform(at) => Source::Uniform(uniform(at)),
            Source::Constant { at, bits } => Source::Constant { at: uniform(at), bits },
        }
    }

    fn sources(&self, sources: &[Source]) -> Vec<Source> {
        sources.iter().map(|source| self.source(*source)).collect()
    }

    fn context(&self, context: &Context) -> Context {
        context.iter().map(|(field, words)| (*field, self.sources(words))).collect()
    }
}
