//! What several functions are made of.

use crate::emit::{Bits, Int};

/// ln 2 in two parts.
pub(super) const LN_2: [f64; 2] = [0.693_147_182_464_599_6, -1.904_654_323_148_236e-9];
/// log2 e in two parts.
pub(super) const LOG2_E: [f64; 2] = [1.442_695_021_629_333_5, 1.925_962_991_126_618_6e-8];
/// pi / 2 in three parts of 24 bits.
pub(super) const HALF_PI: [f64; 3] =
    [1.570_796_370_506_286_6, -4.371_138_828_673_793e-8, -1.715_121_070_519_294e-15];

/// `coefficients[0] + x (coefficients[1] + x (…))`, each step rounded once.
#[inline(always)]
pub(super) fn polynomial<R: Bits, const N: usize>(x: R, coefficients: [f64; N]) -> R {
    let mut sum = x.same(coefficients[N - 1]);
    let mut power = N - 1;
    while power > 0 {
        power -= 1;
        sum = sum.mul_add(x, x.same(coefficients[power]));
    }
    sum
}

/// In low..=high; NaN stays NaN.
#[inline(always)]
pub(super) fn limited<R: Bits>(x: R, low: f64, high: f64) -> R {
    let above = x.same(low).maximum(x);
    x.same(high).minimum(above)
}

/// `2^n` for n in -126..=127; 0 for -127, infinity for 128.
#[inline(always)]
pub(super) fn power_of_two<R: Bits>(n: R::Int) -> R {
    R::from_bits((n + n.same(127)).shift_left(23))
}

/// `value 2^n` for a value near 1 and |n| up to 250, rounded once.
#[inline(always)]
pub(super) fn scaled<R: Bits>(value: R, n: R::Int) -> R {
    // The first product is exact, so that only the second can round to a subnormal number.
    let half = n.shift_right_signed(1);
    value * power_of_two::<R>(half) * power_of_two::<R>(n - half)
}

/// Where the sign bit is set, be it -0 or NaN.
#[inline(always)]
pub(super) fn sign_bit<R: Bits>(x: R) -> R::Int {
    let bits = x.to_bits();
    bits & bits.same(i32::MIN)
}

/// `x` with its sign bit flipped where `sign`, 0 or `i32::MIN`, has it set.
#[inline(always)]
pub(super) fn flipped<R: Bits>(x: R, sign: R::Int) -> R {
    R::from_bits(x.to_bits() ^ sign)
}
