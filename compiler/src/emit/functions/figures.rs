//! Figures in the plane: whether a place is inside.

use crate::emit::{Emit, Mask, Real};

/// A place in the plane, from the middle of a figure.
#[derive(Clone, Copy)]
pub struct Place<R> {
    /// To the right.
    pub x: R,
    /// Upwards.
    pub y: R,
}

/// Where in its tile a coordinate lies, 0..1; 0 for what is not finite.
#[inline(always)]
pub fn within_tile<R: Real>(x: R) -> R {
    (x - x.floor()).saturate()
}

/// Whether the whole number below is odd. Exact: halves and doubles of whole numbers are, and from 2^24
/// on all are even.
#[inline(always)]
pub fn is_odd<R: Real>(x: R) -> R::Mask {
    let whole = x.floor();
    (whole - (whole * 0.5).floor() * 2.0).equal(x.same(1.0))
}

/// The side of a square that has the variance of the parallelogram two steps span, along one axis.
#[inline(always)]
pub fn spread<R: Real>(first: R, second: R) -> R {
    let (first, second) = (first.absolute(), second.absolute());
    let (large, small) = (first.maximum(second), first.minimum(second));
    let share = small.divide_or_zero(large);
    // Scaled, so that no square vanishes or overflows.
    large * share.mul_add(share, large.same(1.0)).sqrt()
}

/// The mean over `width` round a place of what is 1 over even whole numbers and -1 over odd ones. Exactly 1
/// or -1 where no edge is within reach; towards 0 with a growing width.
///
/// The integral of it is a triangle wave, and the difference of two of its values, divided by the width, the mean.
/// For narrow widths both are nearly the same, and rounding is all that is left; so up to 1, where at most one
/// edge is within reach on either side of the nearest, the mean is twice the distance from that over the width.
#[inline(always)]
pub fn mean_sign<R: Real>(at: R, width: R) -> R {
    let one = at.same(1.0);
    let nearest = (at + 0.5).floor();
    let apart = (at - nearest) * 2.0;
    // Where the edge itself is decides the place: nothing is 0 / 0.
    let rising = apart.divide_or_zero(width).clamp_to(-one, one);
    let below = apart.less(at.same(0.0)).select(-one, one);
    let rising = apart.absolute().less(width).select(rising, below);
    let narrow = is_odd(nearest).select(-rising, rising);
    let half = width * 0.5;
    let wide = (triangle(at + half) - triangle(at - half)).divide_or_zero(width);
    width.less_equal(one).select(narrow, wide.clamp_to(-one, one))
}

/// The distance from the nearest even number, 0..1.
#[inline(always)]
fn triangle<R: Real>(x: R) -> R {
    (x - ((x * 0.5 + 0.5).floor() * 2.0)).absolute().saturate()
}

/// Inside a circle.
#[inline(always)]
pub fn in_circle<R: Real>(at: Place<R>, radius: R) -> R::Mask {
    at.x.mul_add(at.x, at.y * at.y).less_equal(radius * radius)
}

/// Inside one of four circles of half the size, beside, above and below the middle.
#[inline(always)]
pub fn in_cloverleaf<R: Real>(at: Place<R>, radius: R) -> R::Mask {
    let (x, y) = (at.x * 2.0, at.y * 2.0);
    in_circle(Place { x: x + radius, y }, radius)
        | in_circle(Place { x: x - radius, y }, radius)
        | in_circle(Place { x, y: y + radius }, radius)
        | in_circle(Place { x, y: y - radius }, radius)
}

/// How far the sides of a regular hexagon through this place are from its middle; two of its sides are
/// upright.
#[inline(always)]
pub fn hexagon_distance<R: Real>(at: Place<R>) -> R {
    let (x, y) = (at.x.absolute(), at.y.absolute());
    x.maximum(x.mul_add(x.same(0.5), y * 0.866_025))
}

/// Inside a hexagon.
#[inline(always)]
pub fn in_hexagon<R: Real>(at: Place<R>, radius: R) -> R::Mask {
    hexagon_distance(at).less_equal(radius)
}

/// Not farther than `radius` from the line between two points.
#[inline(always)]
pub fn on_line<R: Real>(at: Place<R>, from: Place<R>, to: Place<R>, radius: R) -> R::Mask {
    let (x, y) = (at.x - from.x, at.y - from.y);
    let (along_x, along_y) = (to.x - from.x, to.y - from.y);
    let length = along_x.mul_add(along_x, along_y * along_y);
    let share = x.mul_add(along_x, y * along_y).divide_or_zero(length).saturate();
    let (x, y) = (x - along_x * share, y - along_y * share);
    x.mul_add(x, y * y).sqrt().less_equal(radius)
}

/// 1 where it holds, else 0.
#[inline(always)]
pub fn one_where<E: Emit>(e: E, inside: E::Mask) -> E::Real {
    inside.select(e.real(1.0), e.real(0.0))
}
