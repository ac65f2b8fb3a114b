//! Recorded operations evaluated for one point: the portable form of a body's scalar one.

use std::cell::RefCell;

use super::Recorded;
use crate::ops::evaluate;

/// From the input words to the output words.
pub fn run(recorded: &Recorded, inputs: &[u32], outputs: &mut [u32]) {
    WORDS.with_borrow_mut(|words| {
        evaluate::run(&recorded.ops, inputs, words);
        for (output, &id) in outputs.iter_mut().zip(&recorded.outputs) {
            *output = words[id as usize];
        }
    });
}

thread_local! {
    /// What the operations yielded; kept, so that nothing is allocated for a point.
    static WORDS: RefCell<Vec<u32>> = const { RefCell::new(Vec::new()) };
}
