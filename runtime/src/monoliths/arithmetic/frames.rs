use glam::{Mat4, Vec3};
use phenomenon_compiler::emit::functions::conventions::clamp_finite;
use phenomenon_compiler::emit::functions::frames::{self, any_tangent, tangent_along};
use phenomenon_compiler::emit::scalar::F32;
use phenomenon_compiler::emit::{Transform, Vector};

use super::kinds::{SameBits, Std, vec3, vector};
use super::numbers::Numbers;

/// Three axes at right angles, each of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Along the surface.
    pub u: Vec3,
    /// Along the surface, `n × u`.
    pub v: Vec3,
    /// The normal.
    pub n: Vec3,
}

/// Frames, and spaces. Maps are sixteen numbers: rows are where the axes go, the last is the translation.
pub trait Frames: Numbers {
    /// A unit vector at right angles to a unit normal.
    fn any_tangent(normal: Vec3) -> Vec3;
    /// The part of a vector at right angles to a unit normal, at unit length; any where there is none.
    fn tangent_along(vector: Vec3, normal: Vec3) -> Vec3;
    /// The frame of a unit normal whose tangent runs along a vector.
    #[inline(always)]
    fn frame_along(normal: Vec3, vector: Vec3) -> Frame {
        let u = Self::tangent_along(vector, normal);
        Frame { u, v: Self::cross(normal, u), n: normal }
    }
    /// A vector of a frame, given along its axes, in the world.
    fn in_world(frame: &Frame, vector: Vec3) -> Vec3;
    /// Where a map takes a point.
    fn point_through(map: &[f32; 16], point: Vec3) -> Vec3;
    /// Where a map takes a vector, which the translation leaves alone.
    fn vector_through(map: &[f32; 16], vector: Vec3) -> Vec3;
}

/// A share of a vector's length below which its direction is taken for rounding.
const NO_DIRECTION: f32 = 1e-6;

impl Frames for Std {
    #[inline]
    fn any_tangent(normal: Vec3) -> Vec3 {
        // Duff et al. 2017: glam's, but that -0 counts as 0.
        let sign = if normal.z < 0.0 { -1.0 } else { 1.0 };
        let along = -(normal.x * sign) / (sign + normal.z);
        Vec3::new(normal.x * along + 1.0, normal.y * along, -sign * normal.x)
    }

    #[inline]
    fn tangent_along(vector: Vec3, normal: Vec3) -> Vec3 {
        let unit = vector.normalize_or_zero();
        let across = unit - normal * unit.dot(normal);
        if across.abs().max_element() > NO_DIRECTION {
            return across.normalize();
        }
        Self::any_tangent(normal)
    }

    #[inline]
    fn in_world(frame: &Frame, vector: Vec3) -> Vec3 {
        frame.u * vector.x + frame.v * vector.y + frame.n * vector.z
    }

    #[inline]
    fn point_through(map: &[f32; 16], point: Vec3) -> Vec3 {
        Mat4::from_cols_array(map).transform_point3(point)
    }

    #[inline]
    fn vector_through(map: &[f32; 16], vector: Vec3) -> Vec3 {
        Mat4::from_cols_array(map).transform_vector3(vector)
    }
}

impl Frames for SameBits {
    #[inline(always)]
    fn any_tangent(normal: Vec3) -> Vec3 {
        vec3(any_tangent(vector(normal)))
    }

    #[inline(always)]
    fn tangent_along(of: Vec3, normal: Vec3) -> Vec3 {
        vec3(tangent_along(vector(of), vector(normal)))
    }

    #[inline(always)]
    fn in_world(frame: &Frame, of: Vec3) -> Vec3 {
        vec3(as_compiled(frame).world(vector(of)))
    }

    #[inline(always)]
    fn point_through(map: &[f32; 16], point: Vec3) -> Vec3 {
        finite(transform(map).point(vector(point)))
    }

    #[inline(always)]
    fn vector_through(map: &[f32; 16], of: Vec3) -> Vec3 {
        finite(transform(map).vector(vector(of)))
    }
}

/// A frame as the compiler's functions take it.
#[inline(always)]
pub(super) fn as_compiled(frame: &Frame) -> frames::Frame<F32> {
    frames::Frame { u: vector(frame.u), v: vector(frame.v), n: vector(frame.n) }
}

/// A map as the compiler's functions take it.
#[inline(always)]
fn transform(map: &[f32; 16]) -> Transform<F32> {
    let row = |at: usize| Vector { x: F32(map[at]), y: F32(map[at + 1]), z: F32(map[at + 2]) };
    Transform { x: row(0), y: row(4), z: row(8), translation: row(12) }
}

#[inline(always)]
fn finite(of: Vector<F32>) -> Vec3 {
    Vec3::new(clamp_finite(of.x).0, clamp_finite(of.y).0, clamp_finite(of.z).0)
}
