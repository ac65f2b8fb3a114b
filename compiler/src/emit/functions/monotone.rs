//! Cubics from stop to stop that never go past a value.
//!
//! Source: Steffen 1990, A Simple Method for Monotonic Interpolation in One Dimension. All slopes are
//! taken times the length of the passage, so that short ones do not overflow.

use crate::emit::{Mask, Real};

/// A value at a place.
#[derive(Clone, Copy)]
pub struct Stop<R> {
    /// The place.
    pub at: R,
    /// The value.
    pub value: R,
}

/// A passage beside: what its value rises by, and its length; not above 0 where there is none.
#[derive(Clone, Copy)]
struct Beside<R> {
    rise: R,
    length: R,
}

impl<R: Real> Beside<R> {
    /// Its slope times the length of the passage looked at, and that length's share of both.
    #[inline(always)]
    fn against(self, length: R) -> (R, R) {
        let ratio = length.divide_or_zero(self.length).minimum(length.same(1e18));
        (self.rise * ratio, length.divide_or_zero(length + self.length))
    }
}

/// The slope at one end of a passage that rises by `rise`: by the passage beside that end, and where there
/// is none by that beside the other.
#[inline(always)]
fn slope<R: Real>(rise: R, length: R, near: Beside<R>, far: Beside<R>) -> R {
    let (zero, one, two) = (rise.same(0.0), rise.same(1.0), rise.same(2.0));
    let size = rise.absolute();
    // Between two passages.
    let (beside, share) = near.against(length);
    let mean = beside * share + rise * (one - share);
    let least = (mean.absolute() * 0.5).minimum(beside.absolute()).minimum(size) * two;
    let up = rise.greater(zero) & beside.greater(zero);
    let down = rise.less(zero) & beside.less(zero);
    let inner = up.select(least, down.select(-least, zero));
    // At the first or last stop.
    let (beside, share) = far.against(length);
    let outer = rise * (one + share) - beside * share;
    let along = (outer.greater(zero) & rise.greater(zero)) | (outer.less(zero) & rise.less(zero));
    let steep = outer.absolute().greater(size * two);
    let outer = along.select(steep.select(rise * two, outer), zero);
    let outer = far.length.greater(zero).select(outer, rise);
    near.length.greater(zero).select(inner, outer)
}

/// Between the second and the third of four stops, at this share of the way.
#[inline(always)]
pub fn monotone<R: Real>(stops: [Stop<R>; 4], share: R) -> R {
    let [before, start, end, after] = stops;
    let (rise, length) = (end.value - start.value, end.at - start.at);
    let left = Beside { rise: start.value - before.value, length: start.at - before.at };
    let right = Beside { rise: after.value - end.value, length: after.at - end.at };
    let (first, last) = (slope(rise, length, left, right), slope(rise, length, right, left));
    let third = first + last - rise * 2.0;
    let second = rise * 3.0 - first * 2.0 - last;
    let value = share.mul_add(share.mul_add(share.mul_add(third, second), first), start.value);
    let (low, high) = (start.value.minimum(end.value), start.value.maximum(end.value));
    value.clamp_to(low, high)
}
