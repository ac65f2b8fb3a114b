//! Directions in the frame of a surface.

use crate::emit::{Mask, Real, Vector};

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
    /// Any frame round a unit vector, continuous but at one meridian and without division by next to
    /// nothing (Duff and others 2017, Building an Orthonormal Basis, Revisited).
    #[inline(always)]
    pub fn around(n: Vector<R>) -> Self {
        let one = n.z.same(1.0);
        let sign = n.z.less(n.z.same(0.0)).select(-one, one);
        let a = -one / (sign + n.z);
        let b = n.x * n.y * a;
        let u = Vector { x: (sign * n.x * n.x).mul_add(a, one), y: sign * b, z: -(sign * n.x) };
        let v = Vector { x: b, y: (n.y * n.y).mul_add(a, sign), z: -n.y };
        Self { u, v, n }
    }

    /// The frame whose `u` is a tangent put at right angles to the normal; [`Frame::around`] where the
    /// tangent is zero or along the normal.
    #[inline(always)]
    pub fn of(n: Vector<R>, tangent: Vector<R>) -> Self {
        let any = Self::around(n);
        let along = n * tangent.dot(n);
        let flat = tangent - along;
        // What is left of a tangent along the normal is rounding.
        let usable = flat.dot(flat).greater(tangent.dot(tangent) * 1e-10);
        let unit = flat.normalized();
        let u = Vector {
            x: usable.select(unit.x, any.u.x),
            y: usable.select(unit.y, any.u.y),
            z: usable.select(unit.z, any.u.z),
        };
        Self { u, v: n.cross(u), n }
    }

    /// A vector of the world in this frame.
    #[inline(always)]
    pub fn local(&self, vector: Vector<R>) -> Vector<R> {
        Vector { x: vector.dot(self.u), y: vector.dot(self.v), z: vector.dot(self.n) }
    }

    /// A vector of this frame in the world.
    #[inline(always)]
    pub fn world(&self, x: R, y: R, z: R) -> Vector<R> {
        Vector {
            x: self.u.x.mul_add(x, self.v.x.mul_add(y, self.n.x * z)),
            y: self.u.y.mul_add(x, self.v.y.mul_add(y, self.n.y * z)),
            z: self.u.z.mul_add(x, self.v.z.mul_add(y, self.n.z * z)),
        }
    }
}
