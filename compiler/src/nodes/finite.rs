//! Ranges under which arithmetic stays finite.

use std::ops::RangeInclusive;

/// Two numbers of this range have a finite sum.
pub const SUMMAND: RangeInclusive<f64> = -1.7e38..=1.7e38;
/// Three products of two numbers of this range each have a finite sum.
pub const FACTOR: RangeInclusive<f64> = -1e19..=1e19;
/// Six products of three numbers of this range each have a finite sum, which times a fourth is finite too
/// if that is at most 1.
pub const CUBED: RangeInclusive<f64> = -1e12..=1e12;
/// [`FACTOR`] without its negative half: colours that are multiplied.
pub const INTENSITY: RangeInclusive<f64> = 0.0..=1e19;
/// From 0 to 1.
pub const UNIT: RangeInclusive<f64> = 0.0..=1.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_keep_their_promise() {
        let summand = *SUMMAND.end() as f32;
        assert!((summand + summand).is_finite());
        let factor = *FACTOR.end() as f32;
        assert!((factor * factor + factor * factor + factor * factor).is_finite());
        let cubed = *CUBED.end() as f32;
        assert!((6.0 * cubed * cubed * cubed).is_finite());
    }
}
