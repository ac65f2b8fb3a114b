use phenomenon_compiler::emit::functions::figures::{mean_sign, spread};
use phenomenon_compiler::emit::scalar::F32;

use super::kinds::{SameBits, Std};

/// Patterns, and their means over what a pixel covers.
pub trait Patterns {
    /// The mean round a place, over as much as two steps cover, of what is 1 over even whole numbers and -1 over
    /// odd ones.
    fn mean_sign(at: f32, steps: [f32; 2]) -> f32;
}

impl Patterns for Std {
    #[inline]
    fn mean_sign(at: f32, [first, second]: [f32; 2]) -> f32 {
        let width = first.hypot(second);
        if width > 1.0 {
            let half = width / 2.0;
            return ((triangle(at + half) - triangle(at - half)) / width).clamp(-1.0, 1.0);
        }
        // Narrow: where the nearest edge lies in it.
        let nearest = (at + 0.5).floor();
        let apart = 2.0 * (at - nearest);
        let rising = match apart.abs() < width {
            true => apart / width,
            false if apart < 0.0 => -1.0,
            false => 1.0,
        };
        if nearest.rem_euclid(2.0) == 0.0 { rising } else { -rising }
    }
}

/// The distance from the nearest even number, whose slope is the sign.
fn triangle(x: f32) -> f32 {
    (x - 2.0 * (x / 2.0 + 0.5).floor()).abs().min(1.0)
}

impl Patterns for SameBits {
    #[inline(always)]
    fn mean_sign(at: f32, [first, second]: [f32; 2]) -> f32 {
        mean_sign(F32(at), spread(F32(first), F32(second))).0
    }
}
