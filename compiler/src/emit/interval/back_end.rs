//! Sets as a back end.

use super::{Interval, Truth, Whole, Word};
use crate::emit::{Emit, Words};

/// The back end of sets.
#[derive(Clone, Copy, Debug)]
pub struct Intervals;

impl Emit for Intervals {
    type Real = Interval;
    type Int = Whole;
    type Mask = Truth;
    fn real(self, value: f64) -> Interval {
        Interval::constant(value as f32)
    }
    fn int(self, value: i32) -> Whole {
        Whole::constant(value)
    }
    fn mask(self, value: bool) -> Truth {
        Truth::constant(value)
    }
}

impl Words<Intervals> for &[Word] {
    fn real(&self, index: usize) -> Interval {
        match self[index] {
            Word::Number(number) => number,
            // A word of another type: nothing is known of its bits as a number.
            other => Interval { reads: other.reads(), ..Interval::ANYTHING },
        }
    }
    fn int(&self, index: usize) -> Whole {
        match self[index] {
            Word::Integer(whole) => whole,
            other => Whole { reads: other.reads(), ..Whole::ANYTHING },
        }
    }
    fn mask(&self, index: usize) -> Truth {
        match self[index] {
            Word::Truth(truth) => truth,
            other => Truth { reads: other.reads(), ..Truth::OPEN },
        }
    }
}
