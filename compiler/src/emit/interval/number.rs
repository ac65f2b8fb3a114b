//! Intervals of numbers.

use super::truth::same;
use super::{derived, tag};

/// The numbers from `low` to `high`, infinities included, and NaN where `nan` is set. Without any
/// number, `low` is above `high`, and then NaN is what is left.
///
/// Zeros: an end of zero stands for zeros of the signs it admits, -0 lying below 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Smallest number.
    pub low: f32,
    /// Largest number.
    pub high: f32,
    /// Whether it may be NaN.
    pub nan: bool,
    /// Whether it has no gaps where what it was made of has none: nothing was rounded to whole
    /// numbers, chosen by an open condition or made by a function.
    pub smooth: bool,
    /// See [`Word::reads`](super::Word::reads).
    pub reads: u64,
    /// See [`Word::identity`](super::Word::identity).
    pub identity: u64,
}

/// How a value came about, beside its bounds.
#[derive(Clone, Copy)]
pub(super) struct Made {
    pub nan: bool,
    pub smooth: bool,
    pub reads: u64,
    pub identity: u64,
}

impl Interval {
    /// Any number or NaN, of unknown origin.
    pub const ANYTHING: Interval = Interval {
        low: f32::NEG_INFINITY,
        high: f32::INFINITY,
        nan: true,
        smooth: false,
        reads: 0,
        identity: 0,
    };

    /// One number, or NaN.
    pub fn constant(value: f32) -> Self {
        let nan = value.is_nan();
        let (low, high) = if nan { (f32::INFINITY, f32::NEG_INFINITY) } else { (value, value) };
        // NaN is not its own equal: no two of them are one value.
        let bits = if nan { 0 } else { u64::from(value.to_bits()) + 1 };
        let identity = if nan { 0 } else { derived(const { tag("number") }, &[bits]) };
        Self { low, high, nan, smooth: true, reads: 0, identity }
    }

    /// The numbers between; an end of zero stands for zeros of either sign.
    pub fn between(low: f32, high: f32, reads: u64, identity: u64) -> Self {
        Self::made(low, high, Made { nan: false, smooth: true, reads, identity })
    }

    /// NaN bounds, from infinities that cancel, become infinite.
    pub(super) fn made(low: f32, high: f32, made: Made) -> Self {
        let Made { nan, smooth, reads, identity } = made;
        let low = if low.is_nan() { f32::NEG_INFINITY } else { low };
        let high = if high.is_nan() { f32::INFINITY } else { high };
        // An operation may turn the sign of a zero.
        let low = if low == 0.0 { -0.0 } else { low };
        let high = if high == 0.0 { 0.0 } else { high };
        Self { low, high, nan, smooth, reads, identity }
    }

    /// Nothing but NaN.
    pub(super) fn nothing(reads: u64) -> Self {
        Self { reads, ..Self::constant(f32::NAN) }
    }

    /// Whether it holds no number.
    pub fn is_empty(self) -> bool {
        self.low > self.high
    }

    /// The number, where there is but one and no NaN. Zeros of both signs are two.
    pub fn point(self) -> Option<f32> {
        (self.low.to_bits() == self.high.to_bits() && !self.nan).then_some(self.low)
    }

    /// Whether it may be that number, or NaN. The sign of a zero counts.
    pub fn contains(self, number: f32) -> bool {
        match number.is_nan() {
            true => self.nan,
            false => self.low.total_cmp(&number).is_le() && number.total_cmp(&self.high).is_le(),
        }
    }

    /// Whether every value of it lies in the other bounds.
    pub fn is_within(self, low: f32, high: f32) -> bool {
        !self.nan && low <= self.low && self.high <= high
    }

    /// What is left of it between bounds, if anything is.
    pub fn narrowed(self, low: f32, high: f32) -> Self {
        let (from, to) = (self.low.max(low), self.high.min(high));
        if from > to {
            return self;
        }
        let Interval { smooth, reads, identity, .. } = self;
        match (low <= self.low, self.high <= high) {
            (true, true) => Self { nan: false, ..self },
            _ => Self::made(from, to, Made { nan: false, smooth, reads, identity }),
        }
    }

    pub(super) fn is_one_with(self, other: Self) -> bool {
        same(self.identity, other.identity)
    }

    pub(super) fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    pub(super) fn has_infinity(self) -> bool {
        self.low == f32::NEG_INFINITY || self.high == f32::INFINITY
    }

    pub(super) fn ends(self) -> [f32; 2] {
        [self.low, self.high]
    }

    pub(super) fn with(self, operation: u64, other: Self) -> Made {
        Made {
            nan: self.nan || other.nan,
            smooth: self.smooth && other.smooth,
            reads: self.reads | other.reads,
            identity: derived(operation, &[self.identity, other.identity]),
        }
    }

    /// From a monotone operation of one operand; NaN gives NaN.
    pub(super) fn monotone(self, operation: u64, smooth: bool, each: impl Fn(f32) -> f32) -> Self {
        if let Some(point) = self.point() {
            return Self::constant(each(point));
        }
        if self.is_empty() {
            return Self::nothing(self.reads);
        }
        let made = Made {
            nan: self.nan,
            smooth: self.smooth && smooth,
            reads: self.reads,
            identity: derived(operation, &[self.identity]),
        };
        Self::made(each(self.low), each(self.high), made)
    }

    /// From the larger or smaller of two, whose second is taken where one is NaN.
    pub(super) fn extreme(
        self,
        other: Self,
        operation: u64,
        each: impl Fn(f32, f32) -> f32,
    ) -> Self {
        if let (Some(a), Some(b)) = (self.point(), other.point()) {
            return Self::constant(each(a, b));
        }
        if self.is_empty() || self.is_one_with(other) {
            return other;
        }
        let made = Made { nan: other.nan, ..self.with(operation, other) };
        let (mut low, mut high) = (each(self.low, other.low), each(self.high, other.high));
        if other.is_empty() {
            return Self::nothing(made.reads);
        }
        if self.nan {
            (low, high) = (low.min(other.low), high.max(other.high));
        }
        Self::made(low, high, made)
    }

    /// Its square, and something added to it, rounded once.
    pub(super) fn squared_and(self, addend: Self) -> Self {
        let made = self.with(const { tag("square and") }, addend);
        let [near, far] = match (self.has_zero(), self.low.abs() < self.high.abs()) {
            (true, further) => [0.0, if further { self.high } else { self.low }],
            (false, true) => self.ends(),
            (false, false) => [self.high, self.low],
        };
        let (low, high) = (near.mul_add(near, addend.low), far.mul_add(far, addend.high));
        // An infinite square meets the opposite infinity.
        let nan = made.nan || self.has_infinity() && addend.low == f32::NEG_INFINITY;
        Self::made(low, high, Made { nan, ..made })
    }
}
