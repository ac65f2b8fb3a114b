//! Inverse trigonometric functions.

use super::parts::{HALF_PI, flipped, polynomial, sign_bit};
use crate::emit::{Bits, Int, Mask};

/// `asin r = r + r³ P(r²)` for |r| <= 1/2.
const ASIN: [f64; 5] = [0.166_667_52, 0.074_953_094, 0.045_469_154, 0.024_184_741, 0.042_158_4];
/// `atan r = r + r³ P(r²)` for |r| <= 1.
const ATAN: [f64; 9] = [
    -0.333_333,
    0.199_985_3,
    -0.142_640_43,
    0.109_512_94,
    -0.084_016_16,
    0.057_942_15,
    -0.031_177_958,
    0.010_921_507,
    -0.001_796_193_3,
];

/// The arc sine of |x|, or above 1/2 that of the square root of `(1 - |x|)/2`, which is half the
/// angle to the axis; as `r + curve`.
struct Half<R: Bits> {
    above_half: R::Mask,
    r: R,
    curve: R,
}

#[inline(always)]
fn half_angle<R: Bits>(x: R) -> Half<R> {
    let a = x.absolute();
    let above_half = a.greater(a.same(0.5));
    let square = above_half.select((a.same(1.0) - a) * 0.5, a * a);
    let r = above_half.select(square.sqrt(), a);
    Half { above_half, r, curve: (r * square) * polynomial(square, ASIN) }
}

/// Arc sine; NaN outside -1..=1.
#[inline(always)]
pub fn asin<R: Bits>(x: R) -> R {
    let Half { above_half, r, curve } = half_angle(x);
    // pi/2 - 2 (r + curve), with what the first difference loses: the result may be smaller.
    let (quarter_turn, two_r) = (x.same(HALF_PI[0]), r + r);
    let difference = quarter_turn - two_r;
    let lost = (quarter_turn - difference) - two_r;
    let from_axis = difference + curve.mul_add(x.same(-2.0), lost + HALF_PI[1]);
    flipped(above_half.select(from_axis, r + curve), sign_bit(x))
}

/// Arc cosine; NaN outside -1..=1.
#[inline(always)]
pub fn acos<R: Bits>(x: R) -> R {
    let Half { above_half, r, curve } = half_angle(x);
    let angle = r + curve;
    let from_middle = x.same(HALF_PI[0]) - (flipped(angle, sign_bit(x)) - HALF_PI[1]);
    let to_axis = angle * 2.0;
    let opposite = (x.same(2.0 * HALF_PI[0]) - to_axis) + 2.0 * HALF_PI[1];
    let near_axis = x.less(x.same(0.0)).select(opposite, to_axis);
    above_half.select(near_axis, from_middle)
}

/// Arc tangent of `small / large`, neither negative, both not above `large`.
#[inline(always)]
fn first_octant<R: Bits>(small: R, large: R) -> R {
    // Equal: 1 even where both are infinite, 0 where both are 0.
    let both = small.equal(small.same(0.0)).select(small, small.same(1.0));
    let r = small.equal(large).select(both, small / large);
    let square = r * r;
    (r * square).mul_add(polynomial(square, ATAN), r)
}

/// The angle in 0..=pi/2 of a point in the first quarter.
#[inline(always)]
fn first_quarter<R: Bits>(y: R, x: R) -> R {
    let steep = y.greater(x);
    let angle = first_octant(steep.select(x, y), steep.select(y, x));
    steep.select((y.same(HALF_PI[0]) - angle) + HALF_PI[1], angle)
}

/// Arc tangent.
#[inline(always)]
pub fn atan<R: Bits>(x: R) -> R {
    flipped(first_quarter(x.absolute(), x.same(1.0)), sign_bit(x))
}

/// The angle of the point (x, y), in -pi..=pi, with the signs of zeros counting as in IEEE 754.
#[inline(always)]
pub fn atan2<R: Bits>(y: R, x: R) -> R {
    let angle = first_quarter(y.absolute(), x.absolute());
    let opposite = (x.same(2.0 * HALF_PI[0]) - angle) + 2.0 * HALF_PI[1];
    let bits = x.to_bits();
    flipped(bits.less(bits.same(0)).select(opposite, angle), sign_bit(y))
}
