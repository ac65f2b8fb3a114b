//! A node's body in every form, with its type erased.

use super::recorded::{Fixed, Recorded, Recorder, kept, recorder};
use super::{block, point, sets};
use crate::emit::interval::Word;
use crate::emit::{Body, MAX_OUTPUTS};
use crate::ops::{OpId, Tape};
use crate::storage::{Lanes, Placement};

/// One body in every form. Two are native code and need the CPU features of
/// [`Simd::Native`](crate::engine::Simd::Native) to be that; the others evaluate the operations it records.
/// All give the same bits.
#[derive(Clone, Copy)]
pub struct BodyForms {
    /// One point.
    pub scalar: fn(inputs: &[u32], outputs: &mut [u32]),
    /// Blocks of eight points.
    pub wide: fn(lanes: &mut [Lanes], placement: &Placement<'_>),
    recorder: Recorder,
    /// Input words known before shading.
    fixed: Fixed,
    /// Words written.
    pub outputs: usize,
}

impl std::fmt::Debug for BodyForms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BodyForms").field("outputs", &self.outputs).finish_non_exhaustive()
    }
}

impl BodyForms {
    /// The forms of `B`.
    pub const fn of<B: Body>() -> Self {
        const { assert!(B::OUTPUTS <= MAX_OUTPUTS, "a body writes too many words") };
        Self {
            scalar: super::entries::scalar::<B>,
            wide: super::entries::wide::<B>,
            recorder: recorder::<B>,
            fixed: &[],
            outputs: B::OUTPUTS,
        }
    }

    /// The same where these input words are known before shading: what it records is for those numbers
    /// alone. Native forms read them from the words as they do the others.
    #[must_use]
    pub fn with_fixed(self, fixed: &[(usize, i32)]) -> Self {
        if fixed.is_empty() { self } else { Self { fixed: kept(fixed), ..self } }
    }

    /// Its operations.
    pub fn recorded(&self) -> &'static Recorded {
        Recorded::of(self.recorder, self.outputs, self.fixed)
    }

    /// Appends its operations to a tape.
    pub fn record(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]) {
        self.recorded().replay(tape, inputs, outputs);
    }

    /// One point, on any CPU.
    pub fn scalar_portable(&self, inputs: &[u32], outputs: &mut [u32]) {
        point::run(self.recorded(), inputs, outputs);
    }

    /// Blocks of eight points, on any CPU.
    pub fn wide_portable(&self, lanes: &mut [Lanes], placement: &Placement<'_>) {
        block::run(self.recorded(), lanes, placement);
    }

    /// From sets of inputs to sets that hold every output; see [`crate::emit::interval`].
    pub fn intervals(&self, inputs: &[Word], outputs: &mut [Word]) {
        sets::run(self.recorded(), inputs, outputs);
    }

    /// Runs the body itself over a tape, as [`BodyForms::record`] repeats it: what tests hold that to.
    pub fn record_anew(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]) {
        let inputs = crate::ops::TapeInputs::given(tape, inputs).with_fixed(self.fixed);
        (self.recorder)(&inputs, outputs);
    }
}
