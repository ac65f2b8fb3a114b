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

/// The vector whose components along tangent, bitangent (normal × tangent) and normal are given.
#[inline(always)]
pub fn from_frame<R: Real>(vector: Vector<R>, tangent: Vector<R>, normal: Vector<R>) -> Vector<R> {
    let bitangent = normal.cross(tangent);
    tangent.mul_add(vector.x, bitangent.mul_add(vector.y, normal * vector.z))
}
