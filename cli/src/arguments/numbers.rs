//! Numbers in flags.

use std::ops::RangeInclusive;

use phenomenon_runtime::render::SAMPLE_LIMIT;

fn count(text: &str, range: RangeInclusive<u32>, what: &str) -> Result<u32, String> {
    text.parse()
        .ok()
        .filter(|count| range.contains(count))
        .ok_or_else(|| format!("give {what} from {} to {}", range.start(), range.end()))
}

/// Reads `--spp`.
pub fn samples(text: &str) -> Result<u32, String> {
    count(text, 1..=SAMPLE_LIMIT, "a number of samples a pixel")
}

/// Reads `--threads`.
pub fn threads(text: &str) -> Result<usize, String> {
    count(text, 1..=1_024, "a number of threads").map(|threads| threads as usize)
}

/// Reads `--batch`.
pub fn batch(text: &str) -> Result<u32, String> {
    count(text, 1..=65_536, "a number of points")
}

/// Reads `--seed`.
pub fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("give a whole number from 0 to {}", u64::MAX))
}

/// Reads `--exposure`.
pub fn exposure(text: &str) -> Result<f32, String> {
    text.parse()
        .ok()
        .filter(|factor: &f32| factor.is_finite() && *factor > 0.0)
        .ok_or_else(|| "give a finite number above 0, such as 2".into())
}

/// Reads `--tolerance`.
pub fn tolerance(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|tolerance: &f64| tolerance.is_finite() && *tolerance >= 0.0)
        .ok_or_else(|| "give a finite number, 0 or more; 0 asks for the same bits".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_have_both_limits() {
        assert_eq!((samples("1"), samples("1048576")), (Ok(1), Ok(SAMPLE_LIMIT)));
        for text in ["0", "1048577", "-1", "1.5", "", "NaN", "99999999999999999999", "+ 1"] {
            assert!(samples(text).is_err(), "{text}");
        }
        assert!(threads("0").is_err());
        assert!(batch("0").is_err());
        assert_eq!(seed("18446744073709551615"), Ok(u64::MAX));
        assert!(seed("-1").is_err());
    }

    #[test]
    fn an_exposure_is_finite_and_above_zero() {
        assert_eq!(exposure("0.5"), Ok(0.5));
        for text in ["0", "-0", "-1", "NaN", "inf", "1e39", "1e-50"] {
            assert!(exposure(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_tolerance_is_finite_and_not_negative() {
        assert_eq!(tolerance("5e-3"), Ok(0.005));
        assert_eq!(tolerance("0"), Ok(0.0));
        for text in ["NaN", "inf", "-1e-9", "", "small"] {
            assert!(tolerance(text).is_err(), "{text}");
        }
    }
}
