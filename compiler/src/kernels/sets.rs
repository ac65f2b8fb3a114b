//! Recorded operations evaluated over sets of values; see [`crate::emit::interval`].

use super::Recorded;
use crate::emit::Words;
use crate::emit::interval::{Interval, Intervals, Truth, Whole, Word};
use crate::ops::apply::{Registers, apply};
use crate::ops::{Class, OpId};

/// From sets of inputs to sets that hold every output.
pub fn run(recorded: &Recorded, inputs: &[Word], outputs: &mut [Word]) {
    let mut sets = Sets { inputs, words: Vec::with_capacity(recorded.ops.len()) };
    for &op in &recorded.ops {
        let word = apply(op, Intervals, &sets);
        sets.words.push(word);
    }
    for (output, &id) in outputs.iter_mut().zip(&recorded.outputs) {
        *output = sets.words[id as usize];
    }
}

struct Sets<'a> {
    inputs: &'a [Word],
    words: Vec<Word>,
}

impl Registers<Intervals> for Sets<'_> {
    type Word = Word;
    fn load(&self, source: u32) -> Word {
        self.inputs[source as usize]
    }
    fn constant(&self, _: u32) -> Word {
        // What it means is not known; bodies record constants of a type.
        Word::UNKNOWN
    }
    fn class(&self, id: OpId) -> Class {
        match self.words[id as usize] {
            Word::Number(_) => Class::Real,
            Word::Integer(_) => Class::Int,
            Word::Truth(_) => Class::Mask,
        }
    }
    fn real(&self, id: OpId) -> Interval {
        self.words.as_slice().real(id as usize)
    }
    fn int(&self, id: OpId) -> Whole {
        self.words.as_slice().int(id as usize)
    }
    fn mask(&self, id: OpId) -> Truth {
        self.words.as_slice().mask(id as usize)
    }
    fn of_real(&self, value: Interval) -> Word {
        Word::Number(value)
    }
    fn of_int(&self, value: Whole) -> Word {
        Word::Integer(value)
    }
    fn of_mask(&self, value: Truth) -> Word {
        Word::Truth(value)
    }
}
