//! Numbers in flags.

use std::ops::RangeInclusive;

fn count(text: &str, range: RangeInclusive<u32>, what: &str) -> Result<u32, String> {
    text.parse()
        .ok()
        .filter(|count| range.contains(count))
        .ok_or_else(|| format!("give {what} from {} to {}", range.start(), range.end()))
}

/// Reads `--spp`.
pub fn samples(text: &str) -> Result<u32, String> {
    count(text, 1..=65_536, "a number of samples a pixel")
}

/// Reads `--threads`.
pub fn threads(text: &str) -> Result<u32, String> {
    count(text, 1..=1_024, "a number of threads")
}

/// Reads `--batch`.
pub fn batch(text: &str) -> Result<u32, String> {
    count(text, 1..=65_536, "a number of points")
}

/// Reads `--seed`.
pub fn seed(text: &str) -> Result<u32, String> {
    count(text, 0..=u32::MAX, "an integer")
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
        assert_eq!((samples("1"), samples("65536")), (Ok(1), Ok(65_536)));
        for text in ["0", "65537", "-1", "1.5", "", "NaN", "99999999999999999999", "+ 1"] {
            assert!(samples(text).is_err(), "{text}");
        }
        assert!(threads("0").is_err());
        assert!(batch("0").is_err());
        assert_eq!(seed("4294967295"), Ok(u32::MAX));
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
