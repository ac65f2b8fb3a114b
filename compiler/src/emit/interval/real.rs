//! The other operations on intervals of numbers.

use super::arithmetic::bounds;
use super::number::Made;
use super::{Interval, Truth, Whole, derived, functions, tag};
use crate::emit::{Real, Select};

impl Select<Truth> for Interval {
    fn select(mask: Truth, if_true: Self, if_false: Self) -> Self {
        match mask.decided() {
            Some(true) => if_true,
            Some(false) => if_false,
            None if if_true.is_one_with(if_false) => if_true,
            None => {
                let operands = [mask.identity, if_true.identity, if_false.identity];
                Self {
                    low: least(if_true.low, if_false.low),
                    high: -least(-if_true.high, -if_false.high),
                    nan: if_true.nan || if_false.nan,
                    smooth: false,
                    reads: mask.reads | if_true.reads | if_false.reads,
                    identity: derived(const { tag("select") }, &operands),
                }
            }
        }
    }
}

/// The smaller, -0 lying below 0.
fn least(a: f32, b: f32) -> f32 {
    if a.total_cmp(&b).is_lt() { a } else { b }
}

macro_rules! by_rules {
    ($($function:ident($($second:ident)?))+) => {$(
        fn $function(self $(, $second: Self)?) -> Self {
            functions::$function(self $(, $second)?)
        }
    )+};
}

impl Real for Interval {
    type Mask = Truth;
    type Int = Whole;
    fn same(self, value: f64) -> Self {
        Self::constant(value as f32)
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        if let (Some(a), Some(b), Some(c)) = (self.point(), factor.point(), addend.point()) {
            return Self::constant(a.mul_add(b, c));
        }
        let product = self.with(const { tag("multiply add") }, factor);
        let made = Made {
            nan: product.nan || addend.nan,
            smooth: product.smooth && addend.smooth,
            reads: product.reads | addend.reads,
            identity: derived(const { tag("multiply add") }, &[product.identity, addend.identity]),
        };
        if self.is_empty() || factor.is_empty() || addend.is_empty() {
            return Self::nothing(made.reads);
        }
        if self.is_one_with(factor) {
            return Self { identity: made.identity, ..self.squared_and(addend) };
        }
        let vanishes = |a: Self, b: Self| a.has_zero() && b.has_infinity();
        // Opposite infinities meet where the product, or the product and the addend, are infinite.
        let infinite = (self.has_infinity() || factor.has_infinity()) && addend.has_infinity();
        let nan = made.nan || infinite || vanishes(self, factor) || vanishes(factor, self);
        if infinite {
            return Self::made(f32::NEG_INFINITY, f32::INFINITY, Made { nan, ..made });
        }
        let (low, high) = bounds(self, factor, |a, b| {
            let sum = |c: f32| if (a * b).is_nan() { c } else { a.mul_add(b, c) };
            [sum(addend.low), sum(addend.high)]
        });
        Self::made(low, high, Made { nan, ..made })
    }
    fn minimum(self, other: Self) -> Self {
        self.extreme(other, const { tag("minimum") }, |a, b| if a < b { a } else { b })
    }
    fn maximum(self, other: Self) -> Self {
        self.extreme(other, const { tag("maximum") }, |a, b| if a > b { a } else { b })
    }
    fn absolute(self) -> Self {
        if let Some(point) = self.point() {
            return Self::constant(point.abs());
        }
        if self.is_empty() {
            return self;
        }
        let (a, b) = (self.low.abs(), self.high.abs());
        let near = if self.has_zero() { 0.0 } else { a.min(b) };
        let identity = derived(const { tag("absolute") }, &[self.identity]);
        // No zero is negative here.
        Self { low: near, high: a.max(b), identity, ..self }
    }
    fn sqrt(self) -> Self {
        if self.high < 0.0 {
            return Self::nothing(self.reads);
        }
        let (low, nan) = match self.low < 0.0 {
            true => (-0.0, true),
            false => (self.low, self.nan),
        };
        Self { low, nan, ..self }.monotone(const { tag("square root") }, true, f32::sqrt)
    }
    fn floor(self) -> Self {
        self.monotone(const { tag("floor") }, false, f32::floor)
    }
    fn ceil(self) -> Self {
        self.monotone(const { tag("ceil") }, false, f32::ceil)
    }
    fn truncate(self) -> Self {
        self.monotone(const { tag("truncate") }, false, f32::trunc)
    }
    fn round_even(self) -> Self {
        self.monotone(const { tag("round") }, false, f32::round_ties_even)
    }
    fn less(self, other: Self) -> Truth {
        let one = self.is_one_with(other);
        let may_hold = self.low < other.high && !one;
        let may_fail = one || self.nan || other.nan || self.high >= other.low;
        self.compared(other, const { tag("less") }, may_hold, may_fail)
    }
    fn less_equal(self, other: Self) -> Truth {
        let one = self.is_one_with(other);
        let may_hold = self.low <= other.high;
        let may_fail = self.nan || other.nan || self.high > other.low && !one;
        self.compared(other, const { tag("less or equal") }, may_hold, may_fail)
    }
    fn equal(self, other: Self) -> Truth {
        let one = self.is_one_with(other);
        let may_hold = self.low <= other.high && other.low <= self.high;
        // Zeros of either sign are equal.
        let points = self.low == self.high && other.low == other.high && self.low == other.low;
        let may_fail = self.nan || other.nan || !points && !one;
        self.compared(other, const { tag("equal") }, may_hold, may_fail)
    }
    fn not_equal(self, other: Self) -> Truth {
        !self.equal(other)
    }
    fn to_int(self) -> Whole {
        let (low, high) = match (self.is_empty(), self.nan) {
            (true, _) => (0, 0),
            (_, true) => ((self.low as i32).min(0), (self.high as i32).max(0)),
            _ => (self.low as i32, self.high as i32),
        };
        let identity = derived(const { tag("to integer") }, &[self.identity]);
        match low == high {
            true => Whole::constant(low),
            false => Whole { low, high, reads: self.reads, identity },
        }
    }
    by_rules! {
        sin() cos() tan() asin() acos() atan() atan2(x) exp() exp2() expm1() sinh() cosh() tanh()
        ln() log2() log1p() pow(exponent)
    }
}

impl Interval {
    fn compared(self, other: Self, name: u64, may_hold: bool, may_fail: bool) -> Truth {
        // Without numbers on one side there is only NaN, which compares as false.
        let may_hold = may_hold && !self.is_empty() && !other.is_empty();
        let identity = derived(name, &[self.identity, other.identity]);
        Truth::of_comparison(may_hold, may_fail, self.reads | other.reads, identity)
    }
}
