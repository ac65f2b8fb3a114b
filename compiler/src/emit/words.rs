//! How typed values lie in 32-bit words, the one storage all engines share.

use super::{Color, Emit, Transform, Vector};

/// Words a body reads: one source per 32-bit word.
pub trait Words<E: Emit> {
    /// Word `index` as a number.
    fn real(&self, index: usize) -> E::Real;
    /// Word `index` as an integer.
    fn int(&self, index: usize) -> E::Int;
    /// Word `index` as a truth value (all bits set, or none).
    fn mask(&self, index: usize) -> E::Mask;
    /// Word `index` as the plain number it is for all points: that of an input known before shading.
    fn fixed(&self, index: usize) -> i32;
}

/// Words a body writes.
pub trait Sink<E: Emit> {
    /// Writes word `index`.
    fn real(&mut self, index: usize, value: E::Real);
    /// Writes word `index`.
    fn int(&mut self, index: usize, value: E::Int);
    /// Writes word `index` (all bits set, or none).
    fn mask(&mut self, index: usize, value: E::Mask);
}

/// Reads three numbers from `index` on.
#[inline(always)]
pub fn read_vector<E: Emit>(words: &impl Words<E>, index: usize) -> Vector<E::Real> {
    Vector { x: words.real(index), y: words.real(index + 1), z: words.real(index + 2) }
}

/// Reads four numbers from `index` on.
#[inline(always)]
pub fn read_color<E: Emit>(words: &impl Words<E>, index: usize) -> Color<E::Real> {
    Color {
        r: words.real(index),
        g: words.real(index + 1),
        b: words.real(index + 2),
        a: words.real(index + 3),
    }
}

/// Reads four rows of four numbers from `index` on.
#[inline(always)]
pub fn read_transform<E: Emit>(words: &impl Words<E>, index: usize) -> Transform<E::Real> {
    Transform {
        x: read_vector::<E>(words, index),
        y: read_vector::<E>(words, index + 4),
        z: read_vector::<E>(words, index + 8),
        translation: read_vector::<E>(words, index + 12),
    }
}

/// Writes three numbers from `index` on.
#[inline(always)]
pub fn write_vector<E: Emit>(sink: &mut impl Sink<E>, index: usize, value: Vector<E::Real>) {
    sink.real(index, value.x);
    sink.real(index + 1, value.y);
    sink.real(index + 2, value.z);
}

/// Writes four numbers from `index` on.
#[inline(always)]
pub fn write_color<E: Emit>(sink: &mut impl Sink<E>, index: usize, value: Color<E::Real>) {
    sink.real(index, value.r);
    sink.real(index + 1, value.g);
    sink.real(index + 2, value.b);
    sink.real(index + 3, value.a);
}
