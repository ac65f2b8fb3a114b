//! Light from one direction seen from another at a surface, in forms in which nothing cancels.
//!
//! With `s = l + v`, not of unit length, the half vector is `s / |s|`. Sums of 32-bit directions are
//! exact where the directions are nearly opposed, so `s` keeps its relative accuracy at mirror pairs
//! and at grazing angles, and with it the tangent `|n × s| / (n·s)` of the half vector, on which lobes
//! depend. Its sine is never had from its cosine.

use super::conventions::not_negative;
use crate::emit::{Mask, Real, Vector};

/// Two directions at a surface.
#[derive(Clone, Copy, Debug)]
pub struct Facets<R: Real> {
    /// Cosine towards the light, `n·l`.
    pub cosine_in: R,
    /// Cosine towards the viewer, `n·v`.
    pub cosine_out: R,
    /// `l + v`.
    pub sum: Vector<R>,
    /// `n × (l + v)`: as long as the part of the sum along the surface.
    pub across: Vector<R>,
}

impl<R: Real> Facets<R> {
    /// Of a normal, a direction towards the light, and a ray towards the surface, all of unit length.
    #[inline(always)]
    pub fn of(normal: Vector<R>, light: Vector<R>, ray: Vector<R>) -> Self {
        let sum = light - ray;
        Self {
            cosine_in: normal.dot(light),
            cosine_out: -normal.dot(ray),
            sum,
            across: normal.cross(sum),
        }
    }

    /// Whether light and viewer are both above the surface: where they are not, nothing is reflected.
    #[inline(always)]
    pub fn above(&self) -> R::Mask {
        above(self.cosine_in, self.cosine_out)
    }

    /// `n·(l + v)`.
    #[inline(always)]
    pub fn height(&self) -> R {
        self.cosine_in + self.cosine_out
    }

    /// `|l + v|^2`.
    #[inline(always)]
    pub fn squared(&self) -> R {
        self.sum.dot(self.sum)
    }

    /// Cosine between the half vector and either direction, `|l + v| / 2`.
    #[inline(always)]
    pub fn cosine_half(&self) -> R {
        (self.squared().sqrt() * 0.5).saturate()
    }

    /// Squared tangent between normal and half vector.
    #[inline(always)]
    pub fn slope_squared(&self) -> R {
        let height = self.height();
        // Divided before it is squared: heights next to nothing have no square.
        let slope = Vector {
            x: self.across.x / height,
            y: self.across.y / height,
            z: self.across.z / height,
        };
        slope.dot(slope)
    }

    /// 1 less the cosine between the viewer and the mirrored light: half the squared distance of the two.
    #[inline(always)]
    pub fn off_mirror(&self) -> R {
        let apart = self.cosine_in - self.cosine_out;
        apart.mul_add(apart, self.across.dot(self.across)) * 0.5
    }

    /// `value` where light and viewer are above the surface, finite and not negative; else 0.
    #[inline(always)]
    pub fn where_above(&self, value: R) -> R {
        self.above().select(not_negative(value), value.same(0.0))
    }
}

/// Whether both cosines are above 0.
#[inline(always)]
pub fn above<R: Real>(cosine_in: R, cosine_out: R) -> R::Mask {
    let zero = cosine_in.same(0.0);
    cosine_in.greater(zero) & cosine_out.greater(zero)
}

/// Whether light and viewer are above the surface: the condition under which light loops ask for light.
#[inline(always)]
pub fn lit<R: Real>(normal: Vector<R>, light: Vector<R>, ray: Vector<R>) -> R::Mask {
    above(normal.dot(light), -normal.dot(ray))
}
