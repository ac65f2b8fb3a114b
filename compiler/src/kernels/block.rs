//! Recorded operations evaluated block by block: the portable form of a body's wide one.

use std::cell::RefCell;

use super::Recorded;
use super::eight::{Eight, Eights};
use crate::emit::scalar::{Bool, F32, I32};
use crate::ops::apply::{Registers, apply};
use crate::ops::{Class, OpId};
use crate::storage::{LANES, Lanes, Placement};

/// Runs over the blocks. Output slots may be input slots too: a block's inputs are read before its
/// outputs are written.
pub fn run(recorded: &Recorded, lanes: &mut [Lanes], placement: &Placement<'_>) {
    WORDS.with_borrow_mut(|words| {
        for block in placement.range() {
            words.clear();
            for &op in &recorded.ops {
                let word = apply(op, Eights, &Block { lanes, placement, block, words });
                words.push(word);
            }
            for (word, &id) in recorded.outputs.iter().enumerate() {
                lanes[placement.output(word, block)].0 = words[id as usize];
            }
        }
    });
}

type Word = [u32; LANES];

thread_local! {
    /// What the operations yielded; kept, so that nothing is allocated for a call.
    static WORDS: RefCell<Vec<Word>> = const { RefCell::new(Vec::new()) };
}

struct Block<'a> {
    lanes: &'a [Lanes],
    placement: &'a Placement<'a>,
    block: usize,
    words: &'a [Word],
}

impl Registers<Eights> for Block<'_> {
    type Word = Word;
    fn load(&self, source: u32) -> Word {
        self.lanes[self.placement.input(source as usize, self.block)].0
    }
    fn constant(&self, bits: u32) -> Word {
        [bits; LANES]
    }
    fn class(&self, _: OpId) -> Class {
        // Bits are bits.
        Class::Int
    }
    fn real(&self, id: OpId) -> Eight<F32> {
        Eight(self.words[id as usize].map(|bits| F32(f32::from_bits(bits))))
    }
    fn int(&self, id: OpId) -> Eight<I32> {
        Eight(self.words[id as usize].map(|bits| I32(bits as i32)))
    }
    fn mask(&self, id: OpId) -> Eight<Bool> {
        Eight(self.words[id as usize].map(|bits| Bool(bits != 0)))
    }
    fn of_real(&self, value: Eight<F32>) -> Word {
        value.0.map(|number| number.0.to_bits())
    }
    fn of_int(&self, value: Eight<I32>) -> Word {
        value.0.map(|integer| integer.0 as u32)
    }
    fn of_mask(&self, value: Eight<Bool>) -> Word {
        value.0.map(|truth| if truth.0 { u32::MAX } else { 0 })
    }
}
