//! Working memory of engines, lent to one shading call at a time and kept for the next.
//!
//! Shading calls nest (a request shades what its ray hits before it answers), so a thread holds as
//! many as its deepest ray tree had levels.

use std::cell::RefCell;

thread_local! {
    // In boxes: it is some 1,000 bytes, which a call of a single point would spend its time moving.
    #[expect(clippy::vec_box, reason = "elements leave and come back, by pointer")]
    static FREE: RefCell<Vec<Box<Memory>>> = const { RefCell::new(Vec::new()) };
}

/// What one shading call works in.
#[derive(Debug, Default)]
pub(super) struct Memory {
    /// Of the walk.
    pub walk: super::walk::Memory,
    /// Of the executor.
    pub batch: super::execute::Memory,
}

/// Runs `work` with memory of its own.
// Inlined, or a call of a single point would wait for the words of the closure to be written.
#[inline(always)]
pub(super) fn with_memory<T>(work: impl FnOnce(&mut Memory) -> T) -> T {
    let mut memory = FREE.with_borrow_mut(Vec::pop).unwrap_or_default();
    let result = work(&mut memory);
    FREE.with_borrow_mut(|free| free.push(memory));
    result
}
