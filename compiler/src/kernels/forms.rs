//! A node's body compiled for every back end, with its type erased.

use crate::emit::interval::{Intervals, Word};
use crate::emit::scalar::Scalar;
use crate::emit::{Body, MAX_OUTPUTS};
use crate::ops::{OpId, Tape};
use crate::storage::{Lanes, Placement};

/// One body in every back end. The `native` forms need the CPU features of
/// [`Simd::Native`](crate::engine::Simd::Native); all forms give the same bits.
#[derive(Clone, Copy)]
pub struct BodyForms {
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

impl std::fmt::Debug for BodyForms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BodyForms").field("outputs", &self.outputs).finish_non_exhaustive()
    }
}

impl BodyForms {
    /// Compiles `B` for every back end.
    pub const fn of<B: Body>() -> Self {
        const { assert!(B::OUTPUTS <= MAX_OUTPUTS, "a body writes too many words") };
        Self {
            scalar: super::entries::scalar::<B>,
            wide: super::entries::wide::<B>,
            scalar_portable: scalar_portable::<B>,
            wide_portable: super::entries::wide_portable::<B>,
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
