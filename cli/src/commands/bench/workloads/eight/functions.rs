//! Functions of eight numbers, for the arguments that shaders have.
//!
//! Polynomials of Cephes (Moshier, `expf`, `logf`) and, for the sine over half a turn, of DirectXMath.

use std::arch::x86_64::*;
use std::f32::consts::{FRAC_1_PI, LOG2_E, PI};

use super::vector::{Vector8, each};

/// What pi lacks in 32 bits.
const PI_REST: f32 = -8.742_278e-8;
/// The logarithm of 2 in a part of few bits and a rest.
const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];

/// A polynomial, highest power first.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn polynomial<const N: usize>(x: __m256, coefficients: [f32; N]) -> __m256 {
    let mut sum = _mm256_set1_ps(coefficients[0]);
    for coefficient in &coefficients[1..] {
        sum = _mm256_fmadd_ps(sum, x, _mm256_set1_ps(*coefficient));
    }
    sum
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn nearest(x: __m256) -> __m256 {
    _mm256_round_ps::<{ _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC }>(x)
}

/// Sine of an angle of some turns.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn sine(x: __m256) -> __m256 {
    let halves = nearest(_mm256_mul_ps(x, _mm256_set1_ps(FRAC_1_PI)));
    let rest = _mm256_fnmadd_ps(halves, _mm256_set1_ps(PI), x);
    let rest = _mm256_fnmadd_ps(halves, _mm256_set1_ps(PI_REST), rest);
    let odd = _mm256_slli_epi32::<31>(_mm256_cvtps_epi32(halves));
    let square = _mm256_mul_ps(rest, rest);
    const TERMS: [f32; 5] =
        [-2.388_985_9e-8, 2.752_556_2e-6, -1.984_087_4e-4, 8.333_331e-3, -1.666_666_7e-1];
    let cube = _mm256_mul_ps(square, rest);
    let value = _mm256_fmadd_ps(polynomial(square, TERMS), cube, rest);
    _mm256_xor_ps(value, _mm256_castsi256_ps(odd))
}

/// Exponential of a number between -87 and 88.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn exponential(x: __m256) -> __m256 {
    let whole = nearest(_mm256_mul_ps(x, _mm256_set1_ps(LOG2_E)));
    let rest = _mm256_fnmadd_ps(whole, _mm256_set1_ps(LN_2[0]), x);
    let rest = _mm256_fnmadd_ps(whole, _mm256_set1_ps(LN_2[1]), rest);
    const TERMS: [f32; 6] =
        [1.987_569_1e-4, 1.398_2e-3, 8.333_452e-3, 4.166_579_6e-2, 1.666_666_5e-1, 0.5];
    let square = _mm256_mul_ps(rest, rest);
    let one = _mm256_set1_ps(1.0);
    let value = _mm256_fmadd_ps(polynomial(rest, TERMS), square, _mm256_add_ps(rest, one));
    let power = _mm256_slli_epi32::<23>(_mm256_cvtps_epi32(whole));
    _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(value), power))
}

/// Natural logarithm of a positive normal number.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn logarithm(x: __m256) -> __m256 {
    // The mantissa between the roots of 1/2 and 2, by an exponent rounded there.
    let root_half = _mm256_set1_epi32(0x3f35_04f3);
    let bits = _mm256_sub_epi32(_mm256_castps_si256(x), root_half);
    let exponent = _mm256_cvtepi32_ps(_mm256_srai_epi32::<23>(bits));
    let mantissa =
        _mm256_add_epi32(_mm256_and_si256(bits, _mm256_set1_epi32(0x007f_ffff)), root_half);
    let rest = _mm256_sub_ps(_mm256_castsi256_ps(mantissa), _mm256_set1_ps(1.0));
    const TERMS: [f32; 9] = [
        7.037_683_6e-2,
        -1.151_461e-1,
        1.167_699_9e-1,
        -1.242_014_1e-1,
        1.424_932_3e-1,
        -1.666_805_7e-1,
        2.000_071_5e-1,
        -2.499_999_4e-1,
        3.333_333e-1,
    ];
    let square = _mm256_mul_ps(rest, rest);
    let cube = _mm256_mul_ps(square, rest);
    let value = _mm256_mul_ps(polynomial(rest, TERMS), cube);
    let value = _mm256_fmadd_ps(exponent, _mm256_set1_ps(LN_2[1]), value);
    let value = _mm256_fnmadd_ps(square, _mm256_set1_ps(0.5), value);
    _mm256_fmadd_ps(exponent, _mm256_set1_ps(LN_2[0]), _mm256_add_ps(rest, value))
}

/// A positive number to a power.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn power(base: __m256, exponent: __m256) -> __m256 {
    exponential(_mm256_mul_ps(exponent, logarithm(base)))
}

#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn absolute(x: __m256) -> __m256 {
    _mm256_andnot_ps(_mm256_set1_ps(-0.0), x)
}

/// What is left above the next lower integer.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn fraction(x: __m256) -> __m256 {
    _mm256_sub_ps(x, _mm256_floor_ps(x))
}

#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn unit(x: __m256) -> __m256 {
    _mm256_min_ps(_mm256_max_ps(x, _mm256_setzero_ps()), _mm256_set1_ps(1.0))
}

/// The colour of a hue in turns.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub fn hue(hue: __m256, saturation: f32, value: __m256) -> Vector8 {
    let sextants = _mm256_mul_ps(fraction(hue), _mm256_set1_ps(6.0));
    let away = |from: f32| absolute(_mm256_sub_ps(sextants, _mm256_set1_ps(from)));
    let (one, two) = (_mm256_set1_ps(1.0), _mm256_set1_ps(2.0));
    let pure = Vector8 {
        x: _mm256_sub_ps(away(3.0), one),
        y: _mm256_sub_ps(two, away(2.0)),
        z: _mm256_sub_ps(two, away(4.0)),
    };
    let (share, rest) = (_mm256_set1_ps(saturation), _mm256_set1_ps(1.0 - saturation));
    each(pure, |x| _mm256_mul_ps(value, _mm256_fmadd_ps(share, unit(x), rest)))
}
