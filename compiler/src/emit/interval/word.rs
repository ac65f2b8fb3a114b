//! A word as a set of values.

use super::{Interval, Truth, Whole};

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
