//! Logarithms.

use super::parts::{LN_2, LOG2_E, polynomial};
use crate::emit::{Bits, Int, Mask};

/// `ln(1 + f) = f - f²/2 + f³ P(f)` for 1 + f in sqrt(1/2)..sqrt(2).
const LN: [f64; 9] = [
    0.333_333_13,
    -0.250_001_67,
    0.200_022_22,
    -0.166_593_73,
    0.142_096_39,
    -0.125_496_12,
    0.121_076_16,
    -0.109_195_78,
    0.053_543_527,
];

/// `x = 2^exponent (1 + fraction)` with 1 + fraction in sqrt(1/2)..sqrt(2), for finite x above 0.
pub(super) struct Parts<R: Bits> {
    pub(super) exponent: R::Int,
    pub(super) fraction: R,
}

/// Takes apart a normal number.
#[inline(always)]
fn parts_of_normal<R: Bits>(x: R) -> Parts<R> {
    let bits = x.to_bits();
    // The bits of sqrt(1/2): what is above it by a power of two has that exponent.
    let exponent = (bits - bits.same(0x3f35_04f3)).shift_right_signed(23);
    let fraction = R::from_bits(bits - exponent.shift_left(23)) - 1.0;
    Parts { exponent, fraction }
}

/// Takes apart any number above 0, subnormal ones too.
#[inline(always)]
pub(super) fn parts<R: Bits>(x: R) -> Parts<R> {
    let subnormal = x.less(x.same(f64::from(f32::MIN_POSITIVE)));
    let normal = subnormal.select(x * 8_388_608.0, x);
    let Parts { exponent, fraction } = parts_of_normal(normal);
    let exponent = subnormal.select(exponent - exponent.same(23), exponent);
    Parts { exponent, fraction }
}

/// `value` for finite x above `low`; -inf at it, NaN below, x itself for +inf and NaN.
#[inline(always)]
fn in_domain<R: Bits>(x: R, low: f64, value: R) -> R {
    let edge = x.equal(x.same(low)).select(x.same(f64::NEG_INFINITY), x.same(f64::NAN));
    let finite = x.less(x.same(f64::INFINITY)).select(value, x);
    x.less_equal(x.same(low)).select(edge, finite)
}

/// `exponent ln 2 + ln(1 + fraction + low)` for a low part far smaller.
#[inline(always)]
fn ln_of_parts<R: Bits>(exponent: R, f: R, low: R) -> R {
    let square = f * f;
    let rest = (square * f).mul_add(polynomial(f, LN), low);
    let rest = exponent.mul_add(f.same(LN_2[1]), rest);
    let rest = square.mul_add(f.same(-0.5), rest);
    exponent.mul_add(f.same(LN_2[0]), f + rest)
}

/// Natural logarithm: -inf at 0, NaN below.
#[inline(always)]
pub fn ln<R: Bits>(x: R) -> R {
    let Parts { exponent, fraction } = parts(x);
    in_domain(x, 0.0, ln_of_parts(exponent.to_real(), fraction, x.same(0.0)))
}

/// Logarithm to base 2: -inf at 0, NaN below.
#[inline(always)]
pub fn log2<R: Bits>(x: R) -> R {
    let Parts { exponent, fraction: f } = parts(x);
    // f log2(e) in two parts: near 1 it is the whole result.
    let high = f * LOG2_E[0];
    let low = f.mul_add(f.same(LOG2_E[0]), -high);
    let low = f.mul_add(f.same(LOG2_E[1]), low);
    let curve = (f * f) * f.mul_add(polynomial(f, LN), f.same(-0.5));
    let low = curve.mul_add(f.same(LOG2_E[0]), low);
    in_domain(x, 0.0, exponent.to_real() + (high + low))
}

/// `ln(1 + x)`, accurate near 0: -inf at -1, NaN below.
#[inline(always)]
pub fn log1p<R: Bits>(x: R) -> R {
    let one = x.same(1.0);
    let sum = x + 1.0;
    // What the sum lost, exactly.
    let lost = x.less(one).select(x - (sum - 1.0), one - (sum - x));
    let Parts { exponent, fraction } = parts_of_normal(sum);
    let scale = R::from_bits((exponent.same(127) - exponent).shift_left(23));
    // From 2^25 on nothing that matters is lost, and the scale may be no number.
    let lost = x.less(x.same(33_554_432.0)).select(lost * scale, x.same(0.0));
    let f = fraction + lost;
    let low = lost - (f - fraction);
    let value = in_domain(x, -1.0, ln_of_parts(exponent.to_real(), f, low));
    x.equal(x.same(0.0)).select(x, value)
}
