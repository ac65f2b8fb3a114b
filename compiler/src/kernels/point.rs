//! Recorded operations evaluated for one point: the portable form of a body's scalar one.

use std::cell::RefCell;

use super::Recorded;
use crate::emit::scalar::{Bool, F32, I32, Scalar};
use crate::ops::apply::{Registers, apply};
use crate::ops::{Class, OpId};

/// From the input words to the output words.
pub fn run(recorded: &Recorded, inputs: &[u32], outputs: &mut [u32]) {
    WORDS.with_borrow_mut(|words| {
        words.clear();
        for &op in &recorded.ops {
            let word = apply(op, Scalar, &Point { inputs, words });
            words.push(word);
        }
        for (output, &id) in outputs.iter_mut().zip(&recorded.outputs) {
            *output = words[id as usize];
        }
    });
}

thread_local! {
    /// What the operations yielded; kept, so that nothing is allocated for a point.
    static WORDS: RefCell<Vec<u32>> = const { RefCell::new(Vec::new()) };
}

struct Point<'a> {
    inputs: &'a [u32],
    words: &'a [u32],
}

impl Registers<Scalar> for Point<'_> {
    type Word = u32;
    fn load(&self, source: u32) -> u32 {
        self.inputs[source as usize]
    }
    fn constant(&self, bits: u32) -> u32 {
        bits
    }
    fn class(&self, _: OpId) -> Class {
        // Bits are bits.
        Class::Int
    }
    fn real(&self, id: OpId) -> F32 {
        F32(f32::from_bits(self.words[id as usize]))
    }
    fn int(&self, id: OpId) -> I32 {
        I32(self.words[id as usize] as i32)
    }
    fn mask(&self, id: OpId) -> Bool {
        Bool(self.words[id as usize] != 0)
    }
    fn of_real(&self, value: F32) -> u32 {
        value.0.to_bits()
    }
    fn of_int(&self, value: I32) -> u32 {
        value.0 as u32
    }
    fn of_mask(&self, value: Bool) -> u32 {
        if value.0 { u32::MAX } else { 0 }
    }
}
