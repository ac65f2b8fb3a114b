//! Sets of values instead of values: what a body may yield for any inputs of a box.
//!
//! [`Intervals`] is a back end whose numbers are closed intervals of `f32`, whose integers are
//! intervals of `i32` and whose truth is true, false or open. The operations a node's body records are
//! evaluated on it, so that what the checker proves about a node is proved about the code that runs.
//!
//! It is sound: whatever [`scalar`](super::scalar) computes from inputs within the given sets lies
//! in the sets that come out. Rounding to nearest is monotone, so that a bound computed in `f32` at the ends
//! of the operands holds for all that is between, and nothing needs to be rounded outward; functions aside.
//!
//! Values carry an identity, a hash of how they came about. Two with the same identity are the same
//! value, and `x - x`, `x * x`, `x == x` are then taken for what they are.

mod arithmetic;
mod functions;
mod number;
mod real;
mod truth;
mod whole;

pub use number::Interval;
pub use truth::Truth;
pub use whole::Whole;

use super::{Emit, Words};

/// The back end of sets.
#[derive(Clone, Copy, Debug)]
pub struct Intervals;

/// One 32-bit word as a set of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Word {
    /// A number.
    Number(Interval),
    /// An integer.
    Integer(Whole),
    /// A truth value.
    Truth(Truth),
}

impl Word {
    /// Any number at all, of unknown origin.
    pub const UNKNOWN: Word = Word::Number(Interval::ANYTHING);

    /// The input words of the body the value depends on: bit `n` for word `n`, the last bit for all
    /// words from the 64th on.
    pub fn reads(&self) -> u64 {
        match self {
            Word::Number(number) => number.reads,
            Word::Integer(whole) => whole.reads,
            Word::Truth(truth) => truth.reads,
        }
    }

    /// Marks it as what stands in these input words; see [`Word::reads`].
    #[must_use]
    pub fn read_from(mut self, words: u64) -> Self {
        match &mut self {
            Word::Number(number) => number.reads = words,
            Word::Integer(whole) => whole.reads = words,
            Word::Truth(truth) => truth.reads = words,
        }
        self
    }

    /// What it is the value of: the same for two words only if they always have the same value.
    pub fn identity(&self) -> u64 {
        match self {
            Word::Number(number) => number.identity,
            Word::Integer(whole) => whole.identity,
            Word::Truth(truth) => truth.identity,
        }
    }

    /// The same set as the values of something else.
    #[must_use]
    pub fn known_as(mut self, name: u64) -> Self {
        match &mut self {
            Word::Number(number) => number.identity = name,
            Word::Integer(whole) => whole.identity = name,
            Word::Truth(truth) => truth.identity = name,
        }
        self
    }

    /// Whether it is one value only.
    pub fn is_point(&self) -> bool {
        match self {
            Word::Number(number) => number.low == number.high && !number.nan,
            Word::Integer(whole) => whole.point().is_some(),
            Word::Truth(truth) => truth.decided().is_some(),
        }
    }

    /// Whether these bits may be its value.
    pub fn contains(&self, bits: u32) -> bool {
        match self {
            Word::Number(number) => number.contains(f32::from_bits(bits)),
            Word::Integer(whole) => (whole.low..=whole.high).contains(&(bits as i32)),
            Word::Truth(truth) => {
                if bits == 0 {
                    truth.may_fail
                } else {
                    truth.may_hold
                }
            }
        }
    }
}

/// The number of an operation, from its name.
pub const fn tag(name: &str) -> u64 {
    let (bytes, mut hash, mut at) = (name.as_bytes(), 0xcbf2_9ce4_8422_2325_u64, 0);
    while at < bytes.len() {
        hash = (hash ^ bytes[at] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        at += 1;
    }
    hash
}

/// The identity of what an operation makes of operands; 0, that of nothing known, where one of them
/// has that. Hashes of 64 bits: that two values are taken for one by chance is left out of account.
pub fn derived(operation: u64, operands: &[u64]) -> u64 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut hash = operation;
    for &operand in operands {
        if operand == 0 {
            return 0;
        }
        let mixed = (hash.rotate_left(23) ^ operand).wrapping_mul(FACTOR);
        hash = mixed ^ (mixed >> 29);
    }
    hash
}

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
