//! Sets as a back end.

use super::{Interval, Truth, Whole, Word, derived};
use crate::emit::{Emit, Table, Words};

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
    fn table(self, table: Table, index: Whole) -> Interval {
        let [first, end] = [index.low, index.high].map(|at| at.clamp(0, table.last()) as usize);
        let numbers = &table.numbers()[first..=end];
        let smaller = |low: f32, &x: &f32| if x < low { x } else { low };
        let larger = |high: f32, &x: &f32| if x > high { x } else { high };
        let low = numbers.iter().fold(f32::INFINITY, smaller);
        let high = numbers.iter().fold(f32::NEG_INFINITY, larger);
        // Tables may begin at one place and differ in length.
        let (first_number, length) =
            (table.numbers().as_ptr() as u64, table.numbers().len() as u64);
        let identity = derived(first_number, &[length, index.identity]);
        let nan = numbers.iter().any(|x| x.is_nan());
        let known = Interval::between(low, high, index.reads, identity);
        Interval { smooth: false, nan, ..known }
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
    /// The least it may be. What is known before shading is in the recorded operations, of which sets
    /// are made, so none of them asks for it.
    fn fixed(&self, index: usize) -> i32 {
        match self[index] {
            Word::Integer(whole) => whole.low,
            _ => 0,
        }
    }
}
