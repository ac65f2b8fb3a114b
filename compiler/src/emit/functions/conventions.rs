//! Functions that take any numbers and give finite ones: what node bodies call.
//!
//! The conventions stand in one table in `docs/numerics.md`; `tests/conventions.rs` holds each.

use crate::emit::{Int, Mask, Real};

/// NaN becomes 0, an infinity the largest number of its sign.
#[inline(always)]
pub fn clamp_finite<R: Real>(x: R) -> R {
    let largest = f64::from(f32::MAX);
    let number = x.equal(x).select(x, x.same(0.0));
    x.same(largest).minimum(x.same(-largest).maximum(number))
}

/// Below zero and NaN become 0, an infinity the largest number: what light, shares of it and densities are.
#[inline(always)]
pub fn not_negative<R: Real>(x: R) -> R {
    x.clamp_to(x.same(0.0), x.same(f64::from(f32::MAX)))
}

/// Square root, and 0 below zero and for NaN.
#[inline(always)]
pub fn sqrt_or_zero<R: Real>(x: R) -> R {
    x.maximum(x.same(0.0)).sqrt()
}

/// Natural logarithm, and 0 for what has none: zero, negative numbers, NaN.
#[inline(always)]
pub fn ln_or_zero<R: Real>(x: R) -> R {
    x.greater(x.same(0.0)).select(x.ln(), x.same(0.0))
}

/// Logarithm to base 2, and 0 for what has none: zero, negative numbers, NaN.
#[inline(always)]
pub fn log2_or_zero<R: Real>(x: R) -> R {
    x.greater(x.same(0.0)).select(x.log2(), x.same(0.0))
}

/// `x^y`; `x^0` is 1, also for x = 0; 0 for zero to a negative power and for a negative x to a
/// power that is not whole; the largest number where it overflows. NaN gives 0, save for y = 0.
#[inline(always)]
pub fn pow_or_zero<R: Real>(x: R, y: R) -> R {
    let zero = x.same(0.0);
    let power = clamp_finite(x.pow(y));
    // Zero to a negative power is infinite without this.
    let vanishes = x.equal(zero) & y.not_equal(zero);
    vanishes.select(zero, power)
}

/// Arc sine of `x` clamped to -1..=1; NaN counts as -1.
#[inline(always)]
pub fn asin_clamped<R: Real>(x: R) -> R {
    x.clamp_to(x.same(-1.0), x.same(1.0)).asin()
}

/// Arc cosine of `x` clamped to -1..=1; NaN counts as -1.
#[inline(always)]
pub fn acos_clamped<R: Real>(x: R) -> R {
    x.clamp_to(x.same(-1.0), x.same(1.0)).acos()
}

/// The angle of the point (x, y), in -pi..=pi; 0 for the origin whatever the signs of its zeros.
#[inline(always)]
pub fn atan2_or_zero<R: Real>(y: R, x: R) -> R {
    let zero = x.same(0.0);
    (x.equal(zero) & y.equal(zero)).select(zero, y.atan2(x))
}

/// Floored modulo `x - d floor(x / d)`: in `0..d`, or `d..0` for a negative divisor, and so of the
/// divisor's sign. 0 where the divisor is zero, where the quotient is beyond what numbers resolve,
/// and where the result would round to the divisor.
#[inline(always)]
pub fn modulo_or_zero<R: Real>(x: R, divisor: R) -> R {
    let zero = x.same(0.0);
    let size = divisor.absolute();
    let negative = divisor.less(zero);
    // Mirrored so that the divisor is positive.
    let x = negative.select(-x, x);
    let rest = (x / size).floor().mul_add(-size, x);
    // The rounded quotient may be off by one.
    let rest = rest.less(zero).select(rest + size, rest);
    let rest = rest.greater_equal(size).select(rest - size, rest);
    let inside = rest.greater_equal(zero) & rest.less(size);
    inside.select(negative.select(-rest, rest), zero)
}

/// Integer quotient rounded down, and 0 where the divisor is zero. Exact for all integers; the one that
/// is too large, -2^31 / -1, wraps to -2^31.
///
/// Numbers have 24 digits, so a quotient of numbers is off by up to 2^-22 of itself: it is taken of the
/// absolute values, then of what that leaves, and then at most one is wanting. Each remainder lies between
/// -2^31 and 2^31, though products on the way wrap.
#[inline(always)]
pub fn int_divide_or_zero<I: Int>(n: I, divisor: I) -> I {
    let (zero, one) = (n.same(0), n.same(1));
    let (of_n, of_divisor) = (n.less(zero), divisor.less(zero));
    // 2^31 is the bits of -2^31, whose absolute value as a number is right.
    let size = of_n.select(zero - n, n);
    let by = of_divisor.select(zero - divisor, divisor);
    let by_real = by.to_real().absolute();
    let first = (size.to_real().absolute() / by_real).to_int();
    let left = size - first * by;
    let second = first + (left.to_real() / by_real).floor().to_int();
    let left = size - second * by;
    let is_over = !left.less(by) & !by.less(zero);
    let is_under = left.less(zero);
    let quotient = is_under.select(second - one, is_over.select(second + one, second));
    let left = is_under.select(left + by, is_over.select(left - by, left));
    // Of two signs the quotient is negative, and rounded down is away from zero.
    let down = left.equal(zero).select(zero - quotient, zero - quotient - one);
    let signed = (of_n ^ of_divisor).select(down, quotient);
    divisor.equal(zero).select(zero, signed)
}

/// Floored remainder `n - d floor(n / d)` of integers: between 0 and `d`, of the divisor's sign, and exact.
/// 0 where the divisor is zero.
#[inline(always)]
pub fn int_modulo_or_zero<I: Int>(n: I, divisor: I) -> I {
    let rest = n - int_divide_or_zero(n, divisor) * divisor;
    divisor.equal(n.same(0)).select(n.same(0), rest)
}
