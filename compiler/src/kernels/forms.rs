//! A node's body in every form, with its type erased.

use super::entries::{self, Blocks, NativePoint, Point, native_simd};
use super::recorded::{Kept, Recorded, recorder};
use super::{block, point, sets};
use crate::emit::interval::Word;
use crate::emit::{Body, MAX_OUTPUTS};
use crate::ops::{OpId, Tape, fold};
use crate::storage::{Lanes, Placement};

/// One body in every form. Two are native code, where the CPU has what they are compiled for; the others
/// evaluate the operations it records. All give the same bits.
#[derive(Clone, Copy)]
pub struct BodyForms {
    point: Point,
    blocks: Option<(Blocks, usize)>,
    kept: &'static Kept,
    /// Words written.
    pub(crate) outputs: usize,
}

impl std::fmt::Debug for BodyForms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BodyForms").field("outputs", &self.outputs).finish_non_exhaustive()
    }
}

impl BodyForms {
    /// The forms of `B`.
    pub fn of<B: Body>() -> Self {
        const { assert!(B::OUTPUTS <= MAX_OUTPUTS, "a body writes too many words") };
        Self {
            point: entries::point::<B>(),
            blocks: entries::blocks::<B>(),
            kept: Kept::of(recorder::<B>, B::OUTPUTS, &[]),
            outputs: B::OUTPUTS,
        }
    }

    /// The same where these input words are known before shading: what it records is for those numbers
    /// alone. Native forms read them from the words as they do the others.
    #[must_use]
    pub fn with_fixed(self, fixed: &[(usize, i32)]) -> Self {
        if fixed.is_empty() { self } else { Self { kept: self.kept.with_fixed(fixed), ..self } }
    }

    /// Words written.
    pub fn outputs(&self) -> usize {
        self.outputs
    }

    /// One point: natively where the CPU can.
    #[inline]
    pub fn scalar(&self, inputs: &[u32], outputs: &mut [u32]) {
        match self.native_scalar() {
            Some(native) => native.run(inputs, outputs),
            None => self.scalar_portable(inputs, outputs),
        }
    }

    /// The native form for one point, if the CPU runs it.
    #[inline]
    pub fn native_scalar(&self) -> Option<NativePoint> {
        NativePoint::new(self.point)
    }

    /// Blocks of eight points: natively where the CPU can and the body does not have more inputs than
    /// that form takes.
    #[inline]
    pub fn wide(&self, lanes: &mut [Lanes], placement: &Placement<'_>) {
        match self.blocks {
            Some((blocks, most)) if native_simd() && placement.sources.len() <= most => {
                // SAFETY: the CPU was asked.
                unsafe { blocks(lanes, placement) }
            }
            _ => self.wide_portable(lanes, placement),
        }
    }

    /// Its operations.
    pub fn recorded(&self) -> &'static Recorded {
        self.kept.recorded()
    }

    /// Appends its operations to a tape, legal and folded. `ids` is room for positions, taken along from
    /// body to body.
    pub fn record(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId], ids: &mut Vec<OpId>) {
        let legal = self.recorded().legal();
        fold::onto(tape, &legal.ops, |word| inputs[word as usize], ids);
        for (output, &(_, id)) in outputs.iter_mut().zip(&legal.stores) {
            *output = ids[id as usize];
        }
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

    /// Runs the body itself over a tape, neither legal nor folded unless the tape does it: what tests hold
    /// [`BodyForms::record`] to.
    pub fn record_anew(&self, tape: &Tape, inputs: &[OpId], outputs: &mut [OpId]) {
        self.kept.record_anew(tape, inputs, outputs);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::{Emit, Sink, Words};

    /// A number, so many times.
    struct Repeated;
    impl Body for Repeated {
        const OUTPUTS: usize = 1;
        fn run<E: Emit>(e: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
            let sum = (0..words.fixed(1)).fold(e.real(0.0), |sum, _| sum + words.real(0));
            sink.real(0, sum);
        }
    }

    #[test]
    fn a_body_is_recorded_once_for_each_way_to_settle_it() {
        let settled = |count| BodyForms::of::<Repeated>().with_fixed(&[(1, count)]);
        let (twice, again, thrice) = (settled(2), settled(2), settled(3));
        assert!(std::ptr::eq(twice.recorded(), again.recorded()));
        assert!(!std::ptr::eq(twice.recorded(), thrice.recorded()));
        let mut results = [[0], [0]];
        twice.scalar_portable(&[1.5_f32.to_bits(), 2], &mut results[0]);
        thrice.scalar(&[1.5_f32.to_bits(), 3], &mut results[1]);
        assert_eq!(results.map(|[word]| f32::from_bits(word)), [3.0, 4.5]);
    }
}
