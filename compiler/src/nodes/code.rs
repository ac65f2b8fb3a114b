//! A node's body compiled for every back end, with its type erased.

use crate::emit::interval::{Intervals, Word};
use crate::emit::scalar::Scalar;
use crate::emit::{Emit, Sink, Words};
use crate::engine::lanes::{Lanes, Placement};
use crate::ops::{OpId, Tape};

/// Code generic over the back end, from words to words. The [`crate::node`] macro writes the
/// implementations.
pub trait Body: 'static {
    /// Words written.
    const OUTPUTS: usize;
    /// Reads its inputs, computes, writes its outputs.
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>);
}

/// One body in every back end. The `native` forms need the CPU features of
/// [`Simd::Native`](crate::engine::Simd::Native); all forms give the same bits.
#[derive(Clone, Copy)]
pub struct Code {
    /// One point.
    pub scalar: fn(inputs: &[u32], outputs: &mut [u32]),
    /// Blocks of eight points.
    pub wide: fn(lanes: &mut [Lanes], placement: &Placement<'_>),
    /// The portable forms of the two above.
    pub scalar_portable: fn(inputs: &[u32], outputs: &mut [u32]),
    /// See `scalar_portable`.
    pub wide_portable: fn(lanes: &mut [Lanes], placement: &Placement<'_>),
    /// Appends its operations to a tape.
    pub record: fn(tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]),
    /// From sets of inputs to a set that holds every output; see [`crate::emit::interval`].
    pub intervals: fn(inputs: &[Word], outputs: &mut [Word]),
    /// Words written.
    pub outputs: usize,
}

impl std::fmt::Debug for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Code").field("outputs", &self.outputs).finish_non_exhaustive()
    }
}

impl Code {
    /// Compiles `B` for every back end.
    pub const fn of<B: Body>() -> Self {
        Self {
            scalar: crate::engine::lanes::scalar::<B>,
            wide: crate::engine::lanes::wide::<B>,
            scalar_portable: scalar_portable::<B>,
            wide_portable: crate::engine::lanes::wide_portable::<B>,
            record: record::<B>,
            intervals: intervals::<B>,
            outputs: B::OUTPUTS,
        }
    }
}

fn scalar_portable<B: Body>(inputs: &[u32], mut outputs: &mut [u32]) {
    B::run(Scalar, &inputs, &mut outputs);
}

fn record<B: Body>(tape: &Tape, inputs: &[OpId], mut outputs: &mut [OpId]) {
    B::run(tape, &(tape, inputs), &mut outputs);
}

fn intervals<B: Body>(inputs: &[Word], mut outputs: &mut [Word]) {
    B::run(Intervals, &inputs, &mut outputs);
}
