//! Turning vectors, and transforms made of few numbers.

use crate::emit::{Emit, Mask, Real, Transform, Vector};

/// A vector turned round an axis of any length by an angle in radians, counterclockwise seen against the
/// axis; unchanged where the axis is zero.
#[inline(always)]
pub fn rotated<R: Real>(vector: Vector<R>, axis: Vector<R>, angle: R) -> Vector<R> {
    let unit = axis.normalized();
    let half = (angle * 0.5).sin();
    // 1 - cos, without its cancellation.
    let rest = half * half * 2.0;
    let aside = unit.cross(vector) * angle.sin();
    let along = unit * unit.dot(vector) - vector;
    // v + (k x v) sin + (k (k . v) - v) (1 - cos): exact where the angle is 0.
    let turned = vector + (aside + along * rest);
    let turns = axis.largest().greater(angle.same(0.0));
    turns.select(turned, vector)
}

/// The transform that stretches along the axes.
#[inline(always)]
pub fn diagonal<E: Emit>(e: E, x: E::Real, y: E::Real, z: E::Real) -> Transform<E::Real> {
    let zero = e.real(0.0);
    Transform {
        x: Vector { x, y: zero, z: zero },
        y: Vector { x: zero, y, z: zero },
        z: Vector { x: zero, y: zero, z },
        translation: Vector { x: zero, y: zero, z: zero },
    }
}
