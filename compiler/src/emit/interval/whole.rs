//! Intervals of integers that wrap.

use std::ops::{Add, BitAnd, BitOr, BitXor, Mul, Sub};

use super::truth::same;
use super::{Interval, Truth, derived, tag};
use crate::emit::{Int, Select};

/// The integers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whole {
    /// Smallest value.
    pub low: i32,
    /// Largest value, not below `low`.
    pub high: i32,
    /// See [`Word::reads`](super::Word::reads).
    pub reads: u64,
    /// See [`Word::identity`](super::Word::identity).
    pub identity: u64,
}

impl Whole {
    /// Any integer, of unknown origin.
    pub const ANYTHING: Whole = Whole { low: i32::MIN, high: i32::MAX, reads: 0, identity: 0 };

    /// One integer.
    pub fn constant(value: i32) -> Self {
        let identity = derived(const { tag("integer") }, &[u64::from(value as u32) + 1]);
        Self { low: value, high: value, reads: 0, identity }
    }

    /// The value, where there is but one.
    pub fn point(self) -> Option<i32> {
        (self.low == self.high).then_some(self.low)
    }

    /// The integers between; all of them where the bounds lie outside of 32 bits and so wrap.
    fn between(low: i64, high: i64, reads: u64, identity: u64) -> Self {
        match (i32::try_from(low), i32::try_from(high)) {
            (Ok(low), Ok(high)) if low == high => Self::constant(low),
            (Ok(low), Ok(high)) => Self { low, high, reads, identity },
            _ => Self { reads, identity, ..Self::ANYTHING },
        }
    }

    /// From an operation on each of one set, that of its two bounds if it is monotone.
    fn of_one(
        self,
        operation: u64,
        bits: u32,
        bounds: impl Fn(i32, i32) -> Option<(i32, i32)>,
        exact: impl Fn(i32) -> i32,
    ) -> Self {
        if let Some(point) = self.point() {
            return Self::constant(exact(point));
        }
        let identity = derived(operation, &[self.identity, u64::from(bits) + 1]);
        let (low, high) = bounds(self.low, self.high).unwrap_or((i32::MIN, i32::MAX));
        Self::between(low.into(), high.into(), self.reads, identity)
    }

    /// From an operation on bits, which tells little of sets.
    fn of_bits(
        self,
        other: Self,
        operation: u64,
        bounds: Option<(i32, i32)>,
        exact: impl Fn(i32, i32) -> i32,
    ) -> Self {
        if let (Some(a), Some(b)) = (self.point(), other.point()) {
            return Self::constant(exact(a, b));
        }
        let identity = derived(operation, &[self.identity, other.identity]);
        let (low, high) = bounds.unwrap_or((i32::MIN, i32::MAX));
        Self::between(low.into(), high.into(), self.reads | other.reads, identity)
    }
}

macro_rules! arithmetic {
    ($($trait:ident $method:ident $name:literal, |$a:ident, $b:ident| $bounds:expr;)+) => {$(
        impl $trait for Whole {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                if let (Some(a), Some(b)) = (self.point(), other.point()) {
                    let exact = i64::from(a).$method(i64::from(b));
                    return Self::constant(exact as i32);
                }
                let identity = derived(const { tag($name) }, &[self.identity, other.identity]);
                let wide = |x: Self| [i64::from(x.low), i64::from(x.high)];
                let ($a, $b) = (wide(self), wide(other));
                let (low, high) = $bounds;
                Self::between(low, high, self.reads | other.reads, identity)
            }
        }
    )+};
}
arithmetic! {
    Add add "integer add", |a, b| (a[0] + b[0], a[1] + b[1]);
    Sub sub "integer subtract", |a, b| (a[0] - b[1], a[1] - b[0]);
    Mul mul "integer multiply", |a, b| {
        let [p, q, r, s] = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
        (p.min(q).min(r).min(s), p.max(q).max(r).max(s))
    };
}

impl BitAnd for Whole {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        let (set, mask) = if other.point().is_some() { (self, other) } else { (other, self) };
        let bounds = mask.point().and_then(|mask| match mask {
            // The sign alone.
            i32::MIN if set.low >= 0 => Some((0, 0)),
            i32::MIN if set.high < 0 => Some((i32::MIN, i32::MIN)),
            i32::MIN => Some((i32::MIN, 0)),
            mask if mask >= 0 => Some((0, mask)),
            _ => None,
        });
        self.of_bits(other, const { tag("integer and") }, bounds, |a, b| a & b)
    }
}

impl BitOr for Whole {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        self.of_bits(other, const { tag("integer or") }, None, |a, b| a | b)
    }
}

impl BitXor for Whole {
    type Output = Self;
    fn bitxor(self, other: Self) -> Self {
        for (set, mask) in [(self, other), (other, self)] {
            match mask.point() {
                Some(0) => return set,
                // The sign turned: the order within each half stays.
                Some(i32::MIN) if (set.low < 0) == (set.high < 0) => {
                    let bounds = Some((set.low ^ i32::MIN, set.high ^ i32::MIN));
                    return self.of_bits(other, const { tag("integer xor") }, bounds, |a, b| a ^ b);
                }
                _ => {}
            }
        }
        self.of_bits(other, const { tag("integer xor") }, None, |a, b| a ^ b)
    }
}

impl Select<Truth> for Whole {
    fn select(mask: Truth, if_true: Self, if_false: Self) -> Self {
        match mask.decided() {
            Some(true) => if_true,
            Some(false) => if_false,
            None if same(if_true.identity, if_false.identity) => if_true,
            None => {
                let operands = [mask.identity, if_true.identity, if_false.identity];
                Self {
                    low: if_true.low.min(if_false.low),
                    high: if_true.high.max(if_false.high),
                    reads: mask.reads | if_true.reads | if_false.reads,
                    identity: derived(const { tag("select") }, &operands),
                }
            }
        }
    }
}

impl Int for Whole {
    type Mask = Truth;
    type Real = Interval;
    fn same(self, value: i32) -> Self {
        Self::constant(value)
    }
    fn shift_left(self, bits: u32) -> Self {
        let bounds = |low: i32, high: i32| {
            let wide = |x: i32| i32::try_from(i64::from(x) << bits).ok();
            Some((wide(low)?, wide(high)?))
        };
        self.of_one(const { tag("shift left") }, bits, bounds, |x| x << bits)
    }
    fn shift_right(self, bits: u32) -> Self {
        let logical = |x: i32| (x as u32 >> bits) as i32;
        // Monotone among numbers of one sign.
        let bounds = |low: i32, high: i32| match (low < 0) == (high < 0) || bits == 0 {
            true => Some((logical(low), logical(high))),
            false => Some((0, logical(-1))),
        };
        self.of_one(const { tag("shift right") }, bits, bounds, logical)
    }
    fn shift_right_signed(self, bits: u32) -> Self {
        let bounds = |low: i32, high: i32| Some((low >> bits, high >> bits));
        self.of_one(const { tag("shift right signed") }, bits, bounds, |x| x >> bits)
    }
    fn equal(self, other: Self) -> Truth {
        let one = same(self.identity, other.identity);
        let may_hold = one || self.low <= other.high && other.low <= self.high;
        let points = self.point().is_some() && self.point() == other.point();
        let identity = derived(const { tag("integer equal") }, &[self.identity, other.identity]);
        Truth::of_comparison(may_hold, !one && !points, self.reads | other.reads, identity)
    }
    fn less(self, other: Self) -> Truth {
        let one = same(self.identity, other.identity);
        let (may_hold, may_fail) = (self.low < other.high, self.high >= other.low);
        let identity = derived(const { tag("integer less") }, &[self.identity, other.identity]);
        Truth::of_comparison(may_hold && !one, may_fail || one, self.reads | other.reads, identity)
    }
    fn to_real(self) -> Interval {
        let (low, high) = (self.low as f32, self.high as f32);
        Interval::between(
            low,
            high,
            self.reads,
            derived(const { tag("to real") }, &[self.identity]),
        )
    }
}
