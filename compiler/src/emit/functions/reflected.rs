//! What light loops add for one light sample.

use super::conventions::not_negative;
use crate::emit::{Color, Mask, Real};

/// `color light factor` where the surface shows it, else black; finite, and opaque.
#[inline(always)]
pub fn reflected<R: Real>(shows: R::Mask, color: Color<R>, light: Color<R>, factor: R) -> Color<R> {
    let (zero, one) = (factor.same(0.0), factor.same(1.0));
    let all = color * light * factor;
    Color {
        r: shows.select(not_negative(all.r), zero),
        g: shows.select(not_negative(all.g), zero),
        b: shows.select(not_negative(all.b), zero),
        a: one,
    }
}

/// A colour of one number, opaque.
#[inline(always)]
pub fn grey<R: Real>(value: R) -> Color<R> {
    Color { r: value, g: value, b: value, a: value.same(1.0) }
}

/// Each component where `shows`, finite, else black; opaque.
#[inline(always)]
pub fn shown<R: Real>(shows: R::Mask, color: Color<R>) -> Color<R> {
    reflected(shows, color, grey(color.r.same(1.0)), color.r.same(1.0))
}
