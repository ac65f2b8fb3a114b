//! Operations evaluated for one point by the scalar back end.

use super::apply::{Registers, apply};
use super::{Class, Op, OpId};
use crate::emit::scalar::{Bool, F32, I32, Scalar};

/// Fills `words` with the word of each operation; `Load(n)` is word `n` of `inputs`.
pub fn run(ops: &[Op], inputs: &[u32], words: &mut Vec<u32>) {
    words.clear();
    for &op in ops {
        let word = apply(op, Scalar, &Point { inputs, words });
        words.push(word);
    }
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
