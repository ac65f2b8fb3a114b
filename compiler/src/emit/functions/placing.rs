//! Places on pictures.

use super::conventions::{atan2_or_zero, clamp_finite};
use crate::emit::{Real, Vector};

/// A turn, in radians.
const TURN: f64 = std::f64::consts::TAU;

/// Two coordinates as a vector, finite.
#[inline(always)]
pub fn place<R: Real>(u: R, v: R) -> Vector<R> {
    Vector { x: clamp_finite(u), y: clamp_finite(v), z: u.same(0.0) }
}

/// How far round the y axis a direction lies, in turns from -z by way of -x: 0 to 1, and 0.5 at +z and on
/// the axis.
#[inline(always)]
pub fn longitude<R: Real>(x: R, z: R) -> R {
    (atan2_or_zero(x, z) / TURN + 0.5).saturate()
}

/// How far up a direction lies, in half turns: 0 straight down, 1 straight up, 0.5 for no direction. By
/// the arc tangent of both sides: an arc cosine loses half the digits at the poles.
#[inline(always)]
pub fn latitude<R: Real>(direction: Vector<R>) -> R {
    let Vector { x, y, z } = direction.normalized();
    let aside = x.mul_add(x, z * z).sqrt();
    (atan2_or_zero(y, aside) / (TURN / 2.0) + 0.5).saturate()
}
