//! Frames: three unit vectors at right angles, the last a normal.

use crate::emit::{Components, Mask, Real, Vector};

/// A share of a vector's length below which its direction is taken for rounding.
const NO_DIRECTION: f64 = 1e-6;

/// A unit vector at right angles to a unit normal, the same for the same normal and without a jump but where
/// z changes its sign: `(1 + s x^2 a, s x y a, -s x)` with s the sign of z and `a = -1 / (s + z)`. The
/// denominator is never below 1, so nothing cancels at z = -1 (Duff et al. 2017).
#[inline(always)]
pub fn any_tangent<R: Real>(normal: Vector<R>) -> Vector<R> {
    let (zero, one) = (normal.x.same(0.0), normal.x.same(1.0));
    let sign = normal.z.less(zero).select(-one, one);
    let along = -(normal.x * sign) / (sign + normal.z);
    Vector { x: normal.x.mul_add(along, one), y: normal.y * along, z: -(sign * normal.x) }
}

/// The part of a vector at right angles to a unit normal, at unit length; [`any_tangent`] where there is
/// none. It is straightened twice: once leaves an error that grows as the vector nears the normal.
#[inline(always)]
pub fn tangent_along<R: Real>(vector: Vector<R>, normal: Vector<R>) -> Vector<R> {
    let once = across(vector.normalized(), normal);
    let found = once.largest().greater(normal.x.same(NO_DIRECTION));
    found.select(across(once.normalized(), normal), any_tangent(normal)).normalized()
}

/// A vector less its part along a unit normal. No closure: those the compiler need not inline.
#[inline(always)]
fn across<R: Real>(vector: Vector<R>, normal: Vector<R>) -> Vector<R> {
    vector - normal * vector.dot(normal)
}

/// Three axes at right angles, each of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Frame<R: Real> {
    /// Along the surface.
    pub u: Vector<R>,
    /// Along the surface, `n × u`.
    pub v: Vector<R>,
    /// The normal.
    pub n: Vector<R>,
}

impl<R: Real> Frame<R> {
    /// The frame of a unit normal and a unit tangent at right angles to it.
    #[inline(always)]
    pub fn square(n: Vector<R>, tangent: Vector<R>) -> Self {
        Self { u: tangent, v: n.cross(tangent), n }
    }

    /// Any frame round a unit normal: that of [`any_tangent`].
    #[inline(always)]
    pub fn around(n: Vector<R>) -> Self {
        Self::square(n, any_tangent(n))
    }

    /// The frame of a unit normal whose tangent runs along a vector: that of [`tangent_along`].
    #[inline(always)]
    pub fn along(n: Vector<R>, vector: Vector<R>) -> Self {
        Self::square(n, tangent_along(vector, n))
    }

    /// A vector of the world in this frame.
    #[inline(always)]
    pub fn local(&self, vector: Vector<R>) -> Vector<R> {
        Vector { x: vector.dot(self.u), y: vector.dot(self.v), z: vector.dot(self.n) }
    }

    /// A vector of this frame in the world.
    #[inline(always)]
    pub fn world(&self, vector: Vector<R>) -> Vector<R> {
        self.u.mul_add(vector.x, self.v.mul_add(vector.y, self.n * vector.z))
    }
}
