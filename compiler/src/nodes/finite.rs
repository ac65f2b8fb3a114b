//! Ranges under which arithmetic stays finite, and how a result that could leave them is held.

use std::ops::RangeInclusive;

use crate::emit::{Emit, Real};

/// Two numbers of this range have a finite sum.
pub const SUMMAND: RangeInclusive<f64> = -1.7e38..=1.7e38;
/// Three products of two numbers of this range each have a finite sum.
pub const FACTOR: RangeInclusive<f64> = -1e19..=1e19;
/// [`FACTOR`] without its negative half: colours that are multiplied.
pub const INTENSITY: RangeInclusive<f64> = 0.0..=1e19;
/// From 0 to 1.
pub const UNIT: RangeInclusive<f64> = 0.0..=1.0;

/// The largest finite number of a magnitude that overflowed, with its sign; NaN stays.
#[inline(always)]
pub fn held_finite<E: Emit>(e: E, value: E::Real) -> E::Real {
    let most = f64::from(f32::MAX);
    // The constant stands left, so that NaN passes.
    e.real(-most).maximum(e.real(most).minimum(value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::scalar::{F32, Scalar};

    #[test]
    fn only_overflow_is_touched() {
        for (given, expected) in [
            (f32::INFINITY, f32::MAX),
            (f32::NEG_INFINITY, f32::MIN),
            (f32::MAX, f32::MAX),
            (-0.0, -0.0),
            (1e-45, 1e-45),
        ] {
            let held = held_finite(Scalar, F32(given)).0;
            assert_eq!(held.to_bits(), expected.to_bits(), "{given}");
        }
        assert!(held_finite(Scalar, F32(f32::NAN)).0.is_nan());
    }

    #[test]
    fn ranges_keep_their_promise() {
        let summand = *SUMMAND.end() as f32;
        assert!((summand + summand).is_finite());
        let factor = *FACTOR.end() as f32;
        assert!((factor * factor + factor * factor + factor * factor).is_finite());
    }
}
