//! Curves that several nodes bend values by.

use super::conventions::{clamp_finite, pow_or_zero};
use crate::emit::{Mask, Real};

/// `sign(x) |x|^y`: 0 for 0, the largest number where it overflows.
#[inline(always)]
pub fn signed_power<R: Real>(x: R, y: R) -> R {
    let zero = x.same(0.0);
    let power = pow_or_zero(x.absolute(), y);
    let signed = x.less(zero).select(-power, power);
    x.equal(zero).select(zero, signed)
}

/// Where `x` lies between two bounds, as a share clamped to 0..=1. Equal bounds make a step: 1 from the
/// bound on.
#[inline(always)]
pub fn passage<R: Real>(x: R, low: R, high: R) -> R {
    let step = x.less(low).select(x.same(0.0), x.same(1.0));
    let width = high - low;
    let share = ((x - low) / width).saturate();
    width.equal(x.same(0.0)).select(step, share)
}

/// The smaller of two numbers, the corner rounded where they are nearer than `distance`: below it by
/// `distance h^3 / 6`, h the share of the distance that is missing.
#[inline(always)]
pub fn soft_minimum<R: Real>(a: R, b: R, distance: R) -> R {
    let missing = (distance - (a - b).absolute()).maximum(a.same(0.0));
    let share = missing.divide_or_zero(distance);
    let depth = share * share * share * distance * (1.0 / 6.0);
    clamp_finite(a.minimum(b) - depth)
}
