//! Three numbers of eight points, and how the fields of eight points become one.

use std::arch::x86_64::*;

use glam::Vec3A;
use phenomenon_compiler::state::State;

/// Eight points, some of them twice where there are fewer.
pub type Points<'a> = [&'a State; 8];

/// Three numbers of eight points.
#[derive(Clone, Copy)]
pub struct Vector8 {
    pub x: __m256,
    pub y: __m256,
    pub z: __m256,
}

/// A field of eight points.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn field(points: &Points<'_>, of: impl Fn(&State) -> f32) -> __m256 {
    let [a, b, c, d, e, f, g, h] = points.map(of);
    _mm256_setr_ps(a, b, c, d, e, f, g, h)
}

/// A constant.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn splat(constant: Vec3A) -> Vector8 {
    let [x, y, z] = constant.to_array();
    Vector8 { x: _mm256_set1_ps(x), y: _mm256_set1_ps(y), z: _mm256_set1_ps(z) }
}

/// Something done to each component.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn each(a: Vector8, to: impl Fn(__m256) -> __m256) -> Vector8 {
    Vector8 { x: to(a.x), y: to(a.y), z: to(a.z) }
}

/// Something done to both components.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn both(a: Vector8, b: Vector8, to: impl Fn(__m256, __m256) -> __m256) -> Vector8 {
    Vector8 { x: to(a.x, b.x), y: to(a.y, b.y), z: to(a.z, b.z) }
}

/// The scalar product.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn dot(a: Vector8, b: Vector8) -> __m256 {
    let two = _mm256_fmadd_ps(a.y, b.y, _mm256_mul_ps(a.x, b.x));
    _mm256_fmadd_ps(a.z, b.z, two)
}

/// From one number to another.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn lerp(a: __m256, b: __m256, weight: __m256) -> __m256 {
    _mm256_fmadd_ps(_mm256_sub_ps(b, a), weight, a)
}
