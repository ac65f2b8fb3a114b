//! Sine, cosine and tangent.
//!
//! The angle is reduced by multiples of pi/2 held in 72 bits, with fused steps (W. J. Cody and
//! W. Waite's scheme). Beyond [`LARGEST_ANGLE`] the multiple could not be found in one step; there
//! neighbouring numbers are 1/32 radian apart and more, and the angle counts as 0, infinities too.

use super::parts::{HALF_PI, flipped, polynomial, sign_bit};
use crate::emit::{Bits, Int, Mask};

/// Largest |x| whose sine, cosine and tangent are computed: 2^18.
pub const LARGEST_ANGLE: f64 = 262_144.0;

/// `sin r = r + r³ P(r²)` for |r| <= pi/4.
const SIN: [f64; 3] = [-0.166_666_55, 0.008_332_187, -0.000_195_178_9];
/// `cos r = 1 - r²/2 + r⁴ P(r²)`.
const COS: [f64; 3] = [0.041_666_646, -0.001_388_731, 2.443_232_7e-5];

/// `tan r = r + r³ P(r²)` for |r| <= pi/4.
const TAN: [f64; 7] = [
    0.333_333_5,
    0.133_326_72,
    0.054_059_472,
    0.021_282_494,
    0.010_838_746,
    8.217_576_4e-5,
    0.004_381_355_4,
];

/// `|x| = quarter pi/2 + rest`.
struct Angle<R: Bits> {
    quarter: R::Int,
    rest: R,
}

/// `|x|`, and 0 beyond the largest angle; NaN stays.
#[inline(always)]
fn magnitude<R: Bits>(x: R) -> R {
    let a = x.absolute();
    a.greater(a.same(LARGEST_ANGLE)).select(a.same(0.0), a)
}

#[inline(always)]
fn reduced<R: Bits>(x: R) -> Angle<R> {
    let a = magnitude(x);
    let n = (a * std::f64::consts::FRAC_2_PI).round_even();
    // Exact: a whole multiple of 2^-23 (or of the last bit of a) below 1.
    let rest = n.mul_add(a.same(-HALF_PI[0]), a);
    let rest = n.mul_add(a.same(-HALF_PI[1]), rest);
    Angle { quarter: n.to_int(), rest: n.mul_add(a.same(-HALF_PI[2]), rest) }
}

#[inline(always)]
fn sine_of_rest<R: Bits>(r: R) -> R {
    let square = r * r;
    (square * r).mul_add(polynomial(square, SIN), r)
}

#[inline(always)]
fn cosine_of_rest<R: Bits>(r: R) -> R {
    let square = r * r;
    let curve = square.mul_add(polynomial(square, COS), r.same(-0.5));
    square.mul_add(curve, r.same(1.0))
}

#[inline(always)]
fn odd<I: Int>(n: I) -> I::Mask {
    (n & n.same(1)).equal(n.same(1))
}

/// The sign bit for the second half of a turn.
#[inline(always)]
fn second_half<I: Int>(n: I) -> I {
    (n & n.same(2)).shift_left(30)
}

/// Sine and cosine of `x` in radians.
#[inline(always)]
pub fn sin_cos<R: Bits>(x: R) -> (R, R) {
    let Angle { quarter, rest } = reduced(x);
    let (s, c) = (sine_of_rest(rest), cosine_of_rest(rest));
    let swap = odd(quarter);
    let sine = flipped(swap.select(c, s), second_half(quarter) ^ sign_bit(x));
    let cosine = flipped(swap.select(s, c), second_half(quarter + quarter.same(1)));
    (sine, cosine)
}

/// Sine of `x` in radians.
#[inline(always)]
pub fn sin<R: Bits>(x: R) -> R {
    sin_cos(x).0
}

/// Cosine of `x` in radians.
#[inline(always)]
pub fn cos<R: Bits>(x: R) -> R {
    sin_cos(x).1
}

/// Tangent of `x` in radians.
#[inline(always)]
pub fn tan<R: Bits>(x: R) -> R {
    let a = magnitude(x);
    let n = (a * std::f64::consts::FRAC_2_PI).round_even();
    let exact = n.mul_add(a.same(-HALF_PI[0]), a);
    // The second step with what it loses: near pi/4 and in the reciprocal an error of the angle
    // counts more than once.
    let step = n * HALF_PI[1];
    let step_low = n.mul_add(a.same(HALF_PI[1]), -step);
    let r = exact - step;
    let back = r - exact;
    let lost = (exact - (r - back)) - (step + back);
    let low = n.mul_add(a.same(-HALF_PI[2]), lost - step_low);

    let square = r * r;
    let cubic = (square * r) * polynomial(square, TAN);
    let near = r + cubic;
    let tangent = r + near.mul_add(near * low, low + cubic);
    let reciprocal = a.same(-1.0) / tangent;
    flipped(odd(n.to_int()).select(reciprocal, tangent), sign_bit(x))
}
