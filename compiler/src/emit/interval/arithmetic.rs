//! `+ - * /` on intervals of numbers.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::number::Made;
use super::{Interval, derived, tag};

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if let (Some(a), Some(b)) = (self.point(), other.point()) {
            return Self::constant(a + b);
        }
        let made = self.with(const { tag("add") }, other);
        if self.is_empty() || other.is_empty() {
            return Self::nothing(made.reads);
        }
        let cancels = |a: Self, b: Self| a.low == f32::NEG_INFINITY && b.high == f32::INFINITY;
        let nan = made.nan || cancels(self, other) || cancels(other, self);
        Self::made(self.low + other.low, self.high + other.high, Made { nan, ..made })
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        if self.is_one_with(other) && !self.is_empty() {
            let nan = self.nan || self.has_infinity();
            let made = Made { nan, smooth: true, ..self.with(const { tag("subtract") }, other) };
            return match nan {
                true => Self::made(0.0, 0.0, made),
                false => Self::constant(0.0),
            };
        }
        // The same operation in IEEE 754.
        let identity = derived(const { tag("subtract") }, &[self.identity, other.identity]);
        let difference = self + -other;
        match difference.point() {
            Some(_) => difference,
            None => Self { identity, ..difference },
        }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if let (Some(a), Some(b)) = (self.point(), other.point()) {
            return Self::constant(a * b);
        }
        let made = self.with(const { tag("multiply") }, other);
        if self.is_empty() || other.is_empty() {
            return Self::nothing(made.reads);
        }
        if self.is_one_with(other) {
            let identity = made.identity;
            return Self { identity, ..self.squared_and(Self::constant(0.0)) };
        }
        let vanishes = |a: Self, b: Self| a.has_zero() && b.has_infinity();
        let nan = made.nan || vanishes(self, other) || vanishes(other, self);
        let (low, high) = bounds(self, other, |a, b| {
            // Zero times infinity: beside NaN, which is told of, there is zero times what is finite.
            let product = a * b;
            [if product.is_nan() { 0.0 } else { product }; 2]
        });
        Self::made(low, high, Made { nan, ..made })
    }
}

/// The least and the greatest of what the corners of a box yield, each a least and a greatest.
pub(super) fn bounds(
    a: Interval,
    b: Interval,
    corner: impl Fn(f32, f32) -> [f32; 2],
) -> (f32, f32) {
    let (mut low, mut high) = (f32::INFINITY, f32::NEG_INFINITY);
    for x in a.ends() {
        for y in b.ends() {
            let [from, to] = corner(x, y);
            low = if from < low { from } else { low };
            high = if to > high { to } else { high };
        }
    }
    (low, high)
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if let (Some(a), Some(b)) = (self.point(), other.point()) {
            return Self::constant(a / b);
        }
        let made = self.with(const { tag("divide") }, other);
        if self.is_empty() || other.is_empty() {
            return Self::nothing(made.reads);
        }
        let both_infinite = self.has_infinity() && other.has_infinity();
        if self.is_one_with(other) {
            let nan = made.nan || self.has_zero() || both_infinite;
            return Self::made(1.0, 1.0, Made { nan, ..made });
        }
        if other.has_zero() || both_infinite {
            let nan = made.nan || both_infinite || self.has_zero() && other.has_zero();
            let made = Made { nan, smooth: false, ..made };
            return Self::made(f32::NEG_INFINITY, f32::INFINITY, made);
        }
        let (low, high) = bounds(self, other, |a, b| [a / b; 2]);
        Self::made(low, high, made)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        if let Some(point) = self.point() {
            return Self::constant(-point);
        }
        if self.is_empty() {
            return self;
        }
        let identity = derived(const { tag("negate") }, &[self.identity]);
        // Exact, signs of zeros too.
        Self { low: -self.high, high: -self.low, identity, ..self }
    }
}

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl $trait<f64> for Interval {
            type Output = Self;
            fn $method(self, constant: f64) -> Self {
                self.$method(Self::constant(constant as f32))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);
