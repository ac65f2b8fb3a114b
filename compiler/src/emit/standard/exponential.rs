//! Exponentials and hyperbolic functions.

use super::parts::{LN_2, LOG2_E, flipped, limited, polynomial, power_of_two, scaled, sign_bit};
use crate::emit::{Bits, Int, Mask};

/// `e^r = 1 + r + r² P(r)` for |r| <= ln 2 / 2.
const EXP: [f64; 5] = [0.499_999_94, 0.166_665_17, 0.041_668_102, 0.008_369_182, 0.001_383_855_9];
/// `e^r - 1 = r + r² P(r)`, small relative to the result.
const EXPM1: [f64; 6] =
    [0.5, 0.166_666_36, 0.041_666_51, 0.008_341_51, 0.001_393_054_3, 0.000_150_461_86];
/// `2^r = 1 + r P(r)` for |r| <= 1/2.
const EXP2: [f64; 6] =
    [LN_2[0], 0.240_225_94, 0.055_503_663, 0.009_625_445, 0.001_338_792_7, 0.000_133_324_92];
/// `tanh r = r + r³ P(r²)` for |r| <= 0.6.
const TANH: [f64; 5] = [-0.333_333, 0.133_319_36, -0.053_784_717, 0.020_798_625, -0.005_897_966_7];
/// `sinh r = r + r³ P(r²)` for |r| <= 1.
const SINH: [f64; 4] = [0.166_666_67, 0.008_333_310_5, 0.000_198_428_96, 2.782_213_2e-6];

/// Whole multiple `n` of ln 2 nearest to `x`, and the rest.
#[inline(always)]
fn reduced<R: Bits>(x: R) -> (R, R) {
    let n = (x * LOG2_E[0]).round_even();
    // The first step is exact: n ln2 has few bits beyond those that cancel.
    let rest = n.mul_add(x.same(-LN_2[0]), x);
    (n, n.mul_add(x.same(-LN_2[1]), rest))
}

/// `e^x 2^shift`, so that half of an e^x which overflows can be had.
#[inline(always)]
fn exp_shifted<R: Bits>(x: R, shift: i32) -> R {
    let (n, r) = reduced(limited(x, -104.5, 90.0));
    let value = (r * r).mul_add(polynomial(r, EXP), r) + 1.0;
    let n = n.to_int();
    scaled(value, n + n.same(shift))
}

/// `e^x`.
#[inline(always)]
pub fn exp<R: Bits>(x: R) -> R {
    exp_shifted(x, 0)
}

/// `2^x`.
#[inline(always)]
pub fn exp2<R: Bits>(x: R) -> R {
    let x = limited(x, -151.0, 129.0);
    let n = x.round_even();
    let r = x - n;
    scaled(r.mul_add(polynomial(r, EXP2), x.same(1.0)), n.to_int())
}

/// `2^(high + low)` for a low part far smaller.
#[inline(always)]
pub(super) fn exp2_of_sum<R: Bits>(high: R, low: R) -> R {
    let limit = 200.0;
    let small = high.absolute().less(high.same(limit));
    let high = limited(high, -limit, limit);
    let n = high.round_even();
    let r = (high - n) + small.select(low, low.same(0.0));
    scaled(r.mul_add(polynomial(r, EXP2), r.same(1.0)), n.to_int())
}

/// `e^x - 1`, accurate near 0.
#[inline(always)]
pub fn expm1<R: Bits>(x: R) -> R {
    let (n, r) = reduced(limited(x, -20.0, 89.0));
    let fraction = (r * r).mul_add(polynomial(r, EXPM1), r);
    let n = n.to_int();
    // Half of it, since 2^128 is no number: 2^n (fraction + 1) - 1.
    let half: R = power_of_two(n - n.same(1));
    let whole = half.mul_add(fraction, half - 0.5) * 2.0;
    let value = n.equal(n.same(0)).select(fraction, whole);
    x.equal(x.same(0.0)).select(x, value)
}

/// Hyperbolic sine.
#[inline(always)]
pub fn sinh<R: Bits>(x: R) -> R {
    let a = x.absolute();
    let small = (a * (a * a)).mul_add(polynomial(a * a, SINH), a);
    let half = exp_shifted(a, -1);
    let large = half - half.same(0.25) / half;
    flipped(a.less(a.same(1.0)).select(small, large), sign_bit(x))
}

/// Hyperbolic cosine.
#[inline(always)]
pub fn cosh<R: Bits>(x: R) -> R {
    let half = exp_shifted(x.absolute(), -1);
    half + half.same(0.25) / half
}

/// Hyperbolic tangent.
#[inline(always)]
pub fn tanh<R: Bits>(x: R) -> R {
    let a = x.absolute();
    let small = (a * (a * a)).mul_add(polynomial(a * a, TANH), a);
    let a = limited(a, 0.0, 20.0);
    let large = a.same(1.0) - a.same(2.0) / (exp(a * 2.0) + 1.0);
    flipped(x.absolute().less(a.same(0.6)).select(small, large), sign_bit(x))
}
