//! Recorded operations evaluated for one point: the portable form of a body's scalar one.

use super::Recorded;
use crate::emit::scalar::{Bool, F32, I32, Scalar};
use crate::ops::apply::{Registers, apply};
use crate::ops::{Class, OpId};

/// From the input words to the output words.
pub fn run(recorded: &Recorded, inputs: &[u32], outputs: &mut [u32]) {
    let mut point = Point { inputs, words: Vec::with_capacity(recorded.ops.len()) };
    for &op in &recorded.ops {
        let word = apply(op, Scalar, &point);
        point.words.push(word);
    }
    for (output, &id) in outputs.iter_mut().zip(&recorded.outputs) {
        *output = point.words[id as usize];
    }
}

struct Point<'a> {
    inputs: &'a [u32],
    words: Vec<u32>,
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
