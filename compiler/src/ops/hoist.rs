//! What depends on uniform words alone is taken out of segments: it is the same for all points, so it is
//! computed when parameters are bound, and read as a uniform word.
//!
//! A load is not taken out, nor a constant: they cost as much as the load that would take their place.

use std::fmt;

use super::{Op, OpId, OpSegment, Tape, evaluate};
use crate::storage::Source;

/// The operations taken out of all segments of a program.
#[derive(Debug, Default)]
pub struct Hoisted {
    /// Each once. `Load(n)` is uniform word `n`.
    ops: Vec<Op>,
    /// Which of them the words are.
    words: Vec<OpId>,
    /// Position of the first of the words.
    first: u32,
}

impl Hoisted {
    /// The uniform words of the program, followed by those that are computed from them.
    ///
    /// # Panics
    /// If there are fewer or more uniform words than were said.
    pub fn with_words(&self, uniforms: &[u32]) -> Vec<u32> {
        assert_eq!(uniforms.len(), self.first as usize, "they are those of the program");
        let mut values = Vec::with_capacity(self.ops.len());
        evaluate::run(&self.ops, uniforms, &mut values);
        let words = self.words.iter().map(|&id| values[id as usize]);
        uniforms.iter().copied().chain(words).collect()
    }

    /// How many words it computes.
    pub fn words(&self) -> usize {
        self.words.len()
    }
}

impl fmt::Display for Hoisted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.words.is_empty() {
            return Ok(());
        }
        writeln!(f, "when parameters are bound:")?;
        for (id, &op) in self.ops.iter().enumerate() {
            match op {
                Op::Load(at) => writeln!(f, "%{id} = load uniform {at}")?,
                op => writeln!(f, "%{id} = {op}")?,
            }
        }
        for (at, id) in (self.first..).zip(&self.words) {
            writeln!(f, "store uniform {at}, %{id}")?;
        }
        Ok(())
    }
}

/// Takes operations out of segments, one after another.
#[derive(Debug)]
pub struct Hoister {
    tape: Tape,
    words: Vec<OpId>,
    /// By operations of the tape, the uniform word that has it.
    positions: Vec<Option<u32>>,
    first: u32,
}

impl Hoister {
    /// For a program of that many uniform words.
    pub fn new(uniforms: u32) -> Self {
        Self { tape: Tape::new(), words: Vec::new(), positions: Vec::new(), first: uniforms }
    }

    /// All that was taken out.
    pub fn finish(self) -> Hoisted {
        Hoisted { ops: self.tape.into_ops(), words: self.words, first: self.first }
    }

    /// A segment without what depends on uniform words alone. Dead operations must be gone: they would be
    /// computed.
    pub fn hoist(&mut self, segment: OpSegment) -> OpSegment {
        let uniform = uniform(&segment);
        let is_computed = |(op, uniform): (&Op, &bool)| *uniform && !op.is_fetch();
        if !segment.ops.iter().zip(&uniform).any(is_computed) {
            return segment;
        }
        let needed = needed(&segment, &uniform);
        // Where each operation is, on the tape or in the rest.
        let mut taken: Vec<OpId> = vec![0; segment.ops.len()];
        let mut kept: Vec<OpId> = vec![0; segment.ops.len()];
        let mut rest = Rest::new(&segment);
        for (id, &op) in segment.ops.iter().enumerate() {
            if uniform[id] {
                taken[id] = match op {
                    Op::Load(source) => self.load(segment.sources[source as usize]),
                    op => self.tape.push(op.map_operands(|id| taken[id as usize])),
                };
            }
            if !needed[id] {
                continue;
            }
            kept[id] = match op {
                Op::Load(source) => rest.load(source),
                op if uniform[id] && !op.is_fetch() => rest.load_word(self.position(taken[id])),
                op => rest.push(op.map_operands(|id| kept[id as usize])),
            };
        }
        rest.finish(&segment.stores, &kept)
    }

    fn load(&self, source: Source) -> OpId {
        match source {
            Source::Uniform(at) | Source::Constant { at, .. } => self.tape.push(Op::Load(at)),
            Source::Slot(_) => unreachable!("slots are not uniform"),
        }
    }

    /// The uniform word of an operation on the tape.
    fn position(&mut self, id: OpId) -> u32 {
        let at = id as usize;
        self.positions.resize(self.positions.len().max(at + 1), None);
        *self.positions[at].get_or_insert_with(|| {
            self.words.push(id);
            self.first + self.words.len() as u32 - 1
        })
    }
}

/// Which operations depend on uniform words and constants alone.
fn uniform(segment: &OpSegment) -> Vec<bool> {
    let mut uniform: Vec<bool> = Vec::with_capacity(segment.ops.len());
    for &op in &segment.ops {
        let is_uniform = match op {
            Op::Load(source) => !matches!(segment.sources[source as usize], Source::Slot(_)),
            op => {
                let mut all = true;
                op.for_each_operand(|id| all &= uniform[id as usize]);
                all
            }
        };
        uniform.push(is_uniform);
    }
    uniform
}

/// Which operations the rest needs: what differs from point to point, what it reads, and what is stored.
fn needed(segment: &OpSegment, uniform: &[bool]) -> Vec<bool> {
    let mut needed: Vec<bool> = uniform.iter().map(|uniform| !uniform).collect();
    for (id, op) in segment.ops.iter().enumerate() {
        if !uniform[id] {
            op.for_each_operand(|id| needed[id as usize] = true);
        }
    }
    for &(_, id) in &segment.stores {
        needed[id as usize] = true;
    }
    needed
}

/// What stays of a segment.
struct Rest<'a> {
    whole: &'a OpSegment,
    segment: OpSegment,
    /// Sources of the rest by sources of the whole.
    sources: Vec<Option<u32>>,
}

impl<'a> Rest<'a> {
    fn new(whole: &'a OpSegment) -> Self {
        let sources = vec![None; whole.sources.len()];
        let segment = OpSegment { wanted: whole.wanted.clone(), ..OpSegment::default() };
        Self { whole, segment, sources }
    }

    fn push(&mut self, op: Op) -> OpId {
        self.segment.ops.push(op);
        self.segment.ops.len() as OpId - 1
    }

    fn load(&mut self, source: u32) -> OpId {
        let sources = &mut self.segment.sources;
        let at = *self.sources[source as usize].get_or_insert_with(|| {
            sources.push(self.whole.sources[source as usize]);
            sources.len() as u32 - 1
        });
        self.push(Op::Load(at))
    }

    /// Each word is loaded once, for equal operations of a segment are one.
    fn load_word(&mut self, at: u32) -> OpId {
        self.segment.sources.push(Source::Uniform(at));
        self.push(Op::Load(self.segment.sources.len() as u32 - 1))
    }

    fn finish(mut self, stores: &[(u32, OpId)], kept: &[OpId]) -> OpSegment {
        self.segment.stores = stores.iter().map(|&(slot, id)| (slot, kept[id as usize])).collect();
        self.segment
    }
}
