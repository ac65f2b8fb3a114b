use glam::{Vec3, Vec4};
use phenomenon_compiler::emit::scalar::F32;
use phenomenon_compiler::emit::{Color, Vector};

/// The functions of std, and glam: what an author takes who writes one shader.
#[derive(Clone, Copy, Debug)]
pub struct Std;

/// The functions that bodies of nodes call, for one point: what comes out has the bits of the graph's result.
#[derive(Clone, Copy, Debug)]
pub struct SameBits;

/// A vector as the compiler's functions take it.
#[inline(always)]
pub(super) fn vector(of: Vec3) -> Vector<F32> {
    Vector { x: F32(of.x), y: F32(of.y), z: F32(of.z) }
}

/// A vector as the compiler's functions yield it.
#[inline(always)]
pub(super) fn vec3(of: Vector<F32>) -> Vec3 {
    Vec3::new(of.x.0, of.y.0, of.z.0)
}

/// A colour as the compiler's functions take it.
#[inline(always)]
pub(super) fn color(of: Vec4) -> Color<F32> {
    Color { r: F32(of.x), g: F32(of.y), b: F32(of.z), a: F32(of.w) }
}

/// A colour as the compiler's functions yield it, without alpha.
#[inline(always)]
pub(super) fn rgb(of: Color<F32>) -> Vec3 {
    Vec3::new(of.r.0, of.g.0, of.b.0)
}
