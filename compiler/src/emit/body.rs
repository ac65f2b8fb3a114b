//! Code over every back end.

use super::{Emit, Sink, Words};

/// Code generic over the back end, from words to words. The [`crate::node`] macro writes the
/// implementations.
pub trait Body: 'static {
    /// Words written.
    const OUTPUTS: usize;
    /// Reads its inputs, computes, writes its outputs.
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>);
}
