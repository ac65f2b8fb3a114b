//! Code over every back end.

use super::{Emit, Sink, Words};

/// Most words a body may write. Refused where a body is compiled or a definition is made.
pub const MAX_OUTPUTS: usize = 64;

/// Code generic over the back end, from words to words. The [`crate::node`] macro writes the
/// implementations.
pub trait Body: 'static {
    /// Words written, at most [`MAX_OUTPUTS`].
    const OUTPUTS: usize;
    /// Reads its inputs, computes, writes its outputs.
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>);
}
