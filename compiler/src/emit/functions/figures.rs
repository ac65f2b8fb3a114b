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
