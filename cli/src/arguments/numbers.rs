//! Numbers in flags, written as in files: `1e3` and `2.0` are whole, `.5`, `+1` and `0x10` are no
//! numbers. As in files, space round a number means nothing.

use std::ops::RangeInclusive;

use clap::Command;
use phenomenon_compiler::document::numbers::{self, Whole};
use phenomenon_runtime::render::SAMPLE_LIMIT;

/// What flags call the numbers they take.
const PLACEHOLDERS: [&str; 5] = ["N", "FACTOR", "RMS", "WxH", "X,Y,W,H"];

/// The command, where every flag that takes numbers takes what begins with a dash: `-1` is then refused as the number
/// it is, with the range and the remedy of the flag, and not as a flag nobody knows.
pub fn with_dashed_numbers(command: Command) -> Command {
    let command = command.mut_args(|flag| {
        let placeholders = flag.get_value_names().unwrap_or_default();
        match placeholders.iter().any(|name| PLACEHOLDERS.contains(&name.as_str())) {
            true => flag.allow_hyphen_values(true),
            false => flag,
        }
    });
    command.mut_subcommands(with_dashed_numbers)
}

/// A whole number in a range; `what` stands in the message: "a number of threads".
pub(super) fn count<T>(text: &str, range: RangeInclusive<T>, what: &str) -> Result<T, String>
where
    T: Copy + Into<i128> + TryFrom<i128>,
{
    let (low, high): (i128, i128) = ((*range.start()).into(), (*range.end()).into());
    let wanted = || format!("give {what} from {low} to {high}");
    match numbers::whole(text.trim()) {
        Whole::Number(number) if (low..=high).contains(&number) => {
            T::try_from(number).map_err(|_| wanted())
        }
        Whole::Number(_) | Whole::Fraction => Err(wanted()),
        Whole::NoNumber => Err(nearly(text, wanted())),
    }
}

/// What is wanted, and how it is written where something near was given.
fn nearly(text: &str, wanted: String) -> String {
    // A number that is written as it should be is refused for its size.
    let near = numbers::nearest_number(text).filter(|_| numbers::double(text.trim()).is_none());
    match near {
        Some(number) => format!("{wanted}; write {number}"),
        None => wanted,
    }
}

/// Reads `--spp`.
pub fn samples(text: &str) -> Result<u32, String> {
    count(text, 1..=SAMPLE_LIMIT, "a number of samples a pixel")
}

/// Reads `--most-rays`.
pub fn rays(text: &str) -> Result<u64, String> {
    count(text, 1..=u32::MAX, "a number of rays").map(u64::from)
}

/// Reads `--threads`.
pub fn threads(text: &str) -> Result<usize, String> {
    count(text, 1..=1_024_u32, "a number of threads").map(|threads| threads as usize)
}

/// Reads `--batch`.
pub fn batch(text: &str) -> Result<u32, String> {
    count(text, 1..=65_536, "a number of points")
}

/// Reads `--runs`.
pub fn runs(text: &str) -> Result<u8, String> {
    count(text, 1..=100, "a number of runs")
}

/// Reads `--nodes`.
pub fn nodes(text: &str) -> Result<u32, String> {
    count(text, 1..=100_000, "a number of nodes")
}

/// Reads `--seed`.
pub fn seed(text: &str) -> Result<u64, String> {
    count(text, 0..=u64::MAX, "a whole number")
}

/// Reads `--exposure`.
pub fn exposure(text: &str) -> Result<f32, String> {
    numbers::single(text.trim())
        .filter(|factor| *factor > 0.0)
        .ok_or_else(|| nearly(text, "give a finite number above 0, such as 2".into()))
}

/// Reads `--tolerance`.
pub fn tolerance(text: &str) -> Result<f64, String> {
    let wanted = "give a finite number, 0 or more; 0 asks for the same bits";
    numbers::double(text.trim())
        .filter(|tolerance| *tolerance >= 0.0)
        .ok_or_else(|| nearly(text, wanted.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_have_both_limits() {
        assert_eq!((samples("1"), samples("1048576")), (Ok(1), Ok(SAMPLE_LIMIT)));
        assert_eq!((samples("1e3"), samples("2.0"), threads(" 1e0 ")), (Ok(1000), Ok(2), Ok(1)));
        for text in [
            "0",
            "1048577",
            "-1",
            "1.5",
            "",
            "NaN",
            "99999999999999999999",
            "+ 1",
            "+1",
            "01",
            "1.",
            "0x10",
            "1 2",
            "1e-1",
            "1_000",
        ] {
            assert!(samples(text).is_err(), "{text}");
        }
        assert!(threads("0").is_err());
        assert!(batch("0").is_err());
        assert_eq!(seed("18446744073709551615"), Ok(u64::MAX));
        assert_eq!(seed("1.8446744073709551615e19"), Ok(u64::MAX));
        for text in ["-1", "18446744073709551616", "+1", "0.5"] {
            assert!(seed(text).is_err(), "{text}");
        }
        assert!(seed("+7").unwrap_err().ends_with("write 7"));
    }

    #[test]
    fn an_exposure_is_finite_and_above_zero() {
        assert_eq!(exposure("0.5"), Ok(0.5));
        assert_eq!(exposure("1.00000005960464477540"), Ok(1.000_000_1));
        for text in ["0", "-0", "-1", "NaN", "inf", "1e39", "1e-50", ".5", "+1", "1."] {
            assert!(exposure(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_tolerance_is_finite_and_not_negative() {
        assert_eq!(tolerance("5e-3"), Ok(0.005));
        assert_eq!(tolerance("0"), Ok(0.0));
        for text in ["NaN", "inf", "infinity", "-1e-9", "", "small", ".5", "+1", "1e400"] {
            assert!(tolerance(text).is_err(), "{text}");
        }
    }
}
