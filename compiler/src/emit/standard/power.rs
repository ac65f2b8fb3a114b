//! Powers.

use super::exponential;
use super::logarithm::{Parts, parts};
use super::parts::{flipped, polynomial, sign_bit};
use crate::emit::{Bits, Int, Mask};

/// 2 / ln 2 in two parts.
const TWO_LOG2_E: [f64; 2] = [2.885_39, 3.851_926e-8];
/// 2 / (3 ln 2) in two parts.
const THIRD: [f64; 2] = [0.961_796_7, -7.028_462e-9];
/// `log2((1 + s)/(1 - s)) = s (2/ln 2 + s² (2/(3 ln 2) + s² Q(s²)))` for |s| <= 0.1716.
const Q: [f64; 3] = [0.577_078_2, 0.412_066_94, 0.332_495_96];

/// `a + b` for |a| >= |b| or a = 0, and what that sum lost.
#[inline(always)]
fn sum<R: Bits>(a: R, b: R) -> (R, R) {
    let high = a + b;
    (high, (a - high) + b)
}

/// `a b`, and what that product lost.
#[inline(always)]
fn product<R: Bits>(a: R, b: R) -> (R, R) {
    let high = a * b;
    (high, a.mul_add(b, -high))
}

/// log2 of x above 0 as a sum of two numbers, good to about 2^-32 of its value.
#[inline(always)]
fn log2_in_two<R: Bits>(x: R) -> (R, R) {
    let Parts { exponent, fraction: f } = parts(x);
    // s = f / (2 + f), with its remainder.
    let (divisor, divisor_low) = sum(f.same(2.0), f);
    let s = f / divisor;
    let rest = s.mul_add(-divisor, f);
    let s_low = s.mul_add(-divisor_low, rest) / divisor;
    let (square, square_low) = product(s, s);
    let square_low = (s + s).mul_add(s_low, square_low);

    let (a, a_low) = sum(s.same(THIRD[0]), square * polynomial(square, Q));
    let a_low = a_low + THIRD[1];
    let (b, b_low) = product(square, a);
    let b_low = square.mul_add(a_low, square_low.mul_add(a, b_low));
    let (c, c_low) = sum(s.same(TWO_LOG2_E[0]), b);
    let c_low = c_low + (b_low + TWO_LOG2_E[1]);
    let (l, l_low) = product(s, c);
    let l_low = s.mul_add(c_low, s_low.mul_add(c, l_low));
    let (high, low) = sum(exponent.to_real(), l);
    (high, low + l_low)
}

/// `a^y` for a not negative; NaN for 0 or infinity to the power 0, and 1 to an infinite power.
#[inline(always)]
fn pow_of_magnitude<R: Bits>(a: R, y: R) -> R {
    let zero = a.same(0.0);
    let infinity = a.same(f64::INFINITY);
    let (high, low) = log2_in_two(a);
    let regular = a.greater(zero) & a.less(infinity);
    // -inf for 0; infinity and NaN are their own logarithms.
    let edge = a.equal(zero).select(-infinity, a);
    let high = regular.select(high, edge);
    let low = regular.select(low, zero);
    let (exponent, lost) = product(y, high);
    exponential::exp2_of_sum(exponent, y.mul_add(low, lost))
}

/// `x^y` as in IEEE 754: 1 for y = 0 and for x = 1, NaN for a negative finite x and a y that is not
/// whole, infinite for zero to a negative power, with the sign of x for an odd whole y.
#[inline(always)]
pub fn pow<R: Bits>(x: R, y: R) -> R {
    let (zero, one) = (x.same(0.0), x.same(1.0));
    let magnitude = pow_of_magnitude(x.absolute(), y);
    // |x| = 1: 1 to any power, infinite ones too, but NaN stays.
    let magnitude = (x.absolute().equal(one) & y.equal(y)).select(one, magnitude);
    let half = y * 0.5;
    let whole = y.floor().equal(y);
    let odd = whole & half.floor().not_equal(half);
    let sign = odd.select(sign_bit(x), sign_bit(one));
    let signed = flipped(magnitude, sign);
    let finite_negative = x.less(zero) & x.greater(x.same(f64::NEG_INFINITY));
    let value = (finite_negative & !whole).select(x.same(f64::NAN), signed);
    (y.equal(zero) | x.equal(one)).select(one, value)
}
