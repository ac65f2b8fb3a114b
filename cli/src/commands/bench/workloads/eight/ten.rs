//! `ten.json` by hand.

use std::arch::x86_64::*;

use super::functions::{absolute, fraction, hue, unit};
use super::vector::{Points, Vector8, both, dot, field, lerp, splat};
use crate::commands::bench::workloads::ten::{DUST, GLOW, HIGH, LOW, VEIL};

/// A layer of colours in 0..=1 laid over a base; bases of 1 and more pass.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn overlay(base: __m256, layer: __m256) -> __m256 {
    let one = _mm256_set1_ps(1.0);
    let lift = _mm256_mul_ps(_mm256_add_ps(layer, layer), _mm256_sub_ps(one, base));
    let blended = _mm256_mul_ps(base, _mm256_add_ps(base, lift));
    let below_one = _mm256_cmp_ps::<_CMP_LT_OQ>(base, one);
    _mm256_blendv_ps(base, blended, below_one)
}

/// A layer of light over a base; where either reaches 1, the brighter.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn screen(base: __m256, layer: __m256) -> __m256 {
    let one = _mm256_set1_ps(1.0);
    let blended = _mm256_fmadd_ps(layer, _mm256_sub_ps(one, base), base);
    let below_one = _mm256_cmp_ps::<_CMP_LT_OQ>(_mm256_max_ps(base, layer), one);
    _mm256_blendv_ps(_mm256_max_ps(base, layer), blended, below_one)
}

/// Its colours at eight points.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn shade(points: &Points<'_>) -> [__m256; 4] {
    let (zero, one) = (_mm256_setzero_ps(), _mm256_set1_ps(1.0));
    let front = absolute(field(points, |point| point.dot_nd));
    let rim = _mm256_sub_ps(one, front);
    let at = Vector8 {
        x: field(points, |point| point.point[0]),
        y: field(points, |point| point.point[1]),
        z: field(points, |point| point.point[2]),
    };
    let depth = _mm256_sqrt_ps(dot(at, at));
    let somewhere = _mm256_cmp_ps::<_CMP_NEQ_UQ>(depth, zero);
    let up = _mm256_and_ps(somewhere, _mm256_div_ps(at.y, depth));
    let t = unit(_mm256_add_ps(up, _mm256_set1_ps(0.4)));
    let curve = _mm256_sub_ps(_mm256_set1_ps(3.0), _mm256_add_ps(t, t));
    let height = _mm256_mul_ps(_mm256_mul_ps(t, t), curve);
    let ground = both(splat(LOW), splat(HIGH), |low, high| lerp(low, high, height));
    let soft = _mm256_mul_ps(rim, rim);
    let veiled = both(ground, splat(VEIL), |ground, veil| lerp(ground, veil, soft));
    let far = _mm256_add_ps(depth, _mm256_set1_ps(1.5));
    let fade = _mm256_div_ps(_mm256_set1_ps(2.0), far);
    let lit = both(veiled, splat(GLOW), |veiled, glow| _mm256_fmadd_ps(glow, fade, veiled));
    let film = hue(front, 0.7, _mm256_set1_ps(0.9));
    let filmed = both(lit, film, |lit, film| overlay(lit, film));
    let dusty = both(filmed, splat(DUST), |base, dust| screen(base, dust));
    let share = fraction(field(points, |point| point.uv[0]));
    let Vector8 { x, y, z } = both(dusty, lit, |dusty, lit| lerp(dusty, lit, share));
    [x, y, z, one]
}
