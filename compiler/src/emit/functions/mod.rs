//! Functions composed of [`Real`] operations: what node bodies call.

pub mod conventions;

use super::Real;

/// Sine of `x` in radians.
#[inline(always)]
pub fn sin<R: Real>(x: R) -> R {
    x.sin()
}

/// Cosine of `x` in radians.
#[inline(always)]
pub fn cos<R: Real>(x: R) -> R {
    x.cos()
}

/// `e^x`.
#[inline(always)]
pub fn exp<R: Real>(x: R) -> R {
    x.exp()
}
