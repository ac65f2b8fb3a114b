//! `mixed.json` by hand.

use std::arch::x86_64::*;

use super::functions::{exponential, hue, power, sine};
use super::vector::{Points, Vector8, both, dot, each, field, lerp, splat};
use crate::commands::bench::workloads::mixed::LAYERS;

/// Its colours at eight points.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn shade(points: &Points<'_>) -> [__m256; 4] {
    let mut color = Vector8 {
        x: field(points, |point| point.incoming[0]),
        y: field(points, |point| point.incoming[1]),
        z: field(points, |point| point.incoming[2]),
    };
    let mut alpha = field(points, |point| point.incoming[3]);
    let mut toward = Vector8 {
        x: field(points, |point| point.normal[0]),
        y: field(points, |point| point.normal[1]),
        z: field(points, |point| point.normal[2]),
    };
    let (zero, one) = (_mm256_setzero_ps(), _mm256_set1_ps(1.0));
    for layer in &LAYERS {
        let swirl = both(toward, splat(layer.shift), |a, b| _mm256_add_ps(a, b));
        let length = _mm256_sqrt_ps(dot(swirl, swirl));
        let somewhere = _mm256_cmp_ps::<_CMP_NEQ_UQ>(length, zero);
        let scale = _mm256_and_ps(somewhere, _mm256_div_ps(one, length));
        toward = each(swirl, |x| _mm256_mul_ps(x, scale));
        let wave = sine(dot(toward, splat(layer.frequencies)));
        let tone = power(exponential(wave), _mm256_set1_ps(layer.exponent));
        let layered = hue(wave, layer.saturation, tone);
        let weight = _mm256_set1_ps(layer.weight);
        color = both(color, layered, |a, b| lerp(a, b, weight));
        alpha = lerp(alpha, one, weight);
    }
    [color.x, color.y, color.z, alpha]
}
