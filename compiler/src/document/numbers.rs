//! Numbers as text: one grammar and one rounding, wherever a number is given: in a graph, a scene, a
//! flag.
//!
//! The grammar is JSON's: `-0`, `1`, `2.5e-3`, but no `+1`, `.5`, `1.`, `01`, `0x10`, `NaN` or
//! `inf`.

/// The single nearest to a decimal number, rounded once; none for what is no number of JSON, or not
/// finite in 32 bits.
pub fn single(text: &str) -> Option<f32> {
    let number = is_number(text).then(|| text.parse::<f32>().ok())??;
    number.is_finite().then_some(number)
}

/// The double for a decimal number; none for what is no number of JSON, or not finite in 64 bits.
///
/// It is the nearest double, but for one case: a double that lies half way between two singles while
/// the decimal does not would be rounded to the wrong one later. Then it is the double next to that
/// on the side of the decimal. So whatever rounds the result to 32 bits gets what [`single`] gives,
/// and no decimal is ever rounded twice.
pub fn double(text: &str) -> Option<f64> {
    let nearest = is_number(text).then(|| text.parse::<f64>().ok())??;
    if !nearest.is_finite() {
        return None;
    }
    let once = text.parse::<f32>().ok()?;
    let twice = nearest as f32;
    // Where both overflow they are the same infinity.
    Some(match once.partial_cmp(&twice) {
        Some(std::cmp::Ordering::Less) => nearest.next_down(),
        Some(std::cmp::Ordering::Greater) => nearest.next_up(),
        _ => nearest,
    })
}

/// What a number is as a whole number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whole {
    /// This one, exactly. Whole numbers past 128 bits are the largest or the smallest there is.
    Number(i128),
    /// It has a fraction.
    Fraction,
    /// It is no number of JSON.
    NoNumber,
}

/// The whole number a text is. `2.0`, `20e-1` and `2e0` are 2, as exactly as they are written.
pub fn whole(text: &str) -> Whole {
    if !is_number(text) {
        return Whole::NoNumber;
    }
    let (negative, magnitude) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (mantissa, exponent) = match magnitude.split_once(['e', 'E']) {
        // Past 64 bits no file is long enough to make up for it.
        Some((mantissa, exponent)) => (mantissa, exponent_of(exponent)),
        None => (magnitude, 0),
    };
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = || before.bytes().chain(after.bytes());
    // How many digits stand before the point once it is moved, and where the last one that counts is.
    let Some(last) = digits().enumerate().filter(|(_, digit)| *digit != b'0').last() else {
        return Whole::Number(0);
    };
    let count = (before.len() as i64).saturating_add(exponent);
    if count <= last.0 as i64 {
        return Whole::Fraction;
    }
    let limit = if negative { i128::MIN } else { i128::MAX };
    let mut sum: i128 = 0;
    let zeros = std::iter::repeat(b'0');
    // Leading zeros cost nothing, and past 40 digits that count it is too large in any case.
    let significant = digits().chain(zeros).enumerate();
    for (at, digit) in significant.skip_while(|(_, digit)| *digit == b'0') {
        if at as i64 >= count {
            break;
        }
        let digit = i128::from(digit - b'0');
        let next = sum
            .checked_mul(10)
            .and_then(|sum| if negative { sum.checked_sub(digit) } else { sum.checked_add(digit) });
        match next {
            Some(next) => sum = next,
            None => return Whole::Number(limit),
        }
    }
    Whole::Number(sum)
}

fn exponent_of(text: &str) -> i64 {
    let limit = if text.starts_with('-') { i64::MIN } else { i64::MAX };
    text.parse().unwrap_or(limit)
}

/// Whether a text is a number of JSON (RFC 8259, section 6).
pub fn is_number(text: &str) -> bool {
    let rest = text.strip_prefix('-').unwrap_or(text);
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(rest);
    if whole == 0 || (whole > 1 && rest.starts_with('0')) {
        return false;
    }
    let mut rest = &rest[whole..];
    if let Some(fraction) = rest.strip_prefix('.') {
        let count = digits(fraction);
        if count == 0 {
            return false;
        }
        rest = &fraction[count..];
    }
    if let Some(exponent) = rest.strip_prefix(['e', 'E']) {
        let exponent = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        let count = digits(exponent);
        return count > 0 && count == exponent.len();
    }
    rest.is_empty()
}

/// Whether a text is a word for what is not finite: `NaN`, `inf`, `-Infinity`.
pub fn names_no_finite(text: &str) -> bool {
    let word = text.trim_start_matches(['+', '-']);
    ["nan", "inf", "infinity"].iter().any(|name| word.eq_ignore_ascii_case(name))
}

/// The number of JSON that a text nearly is: `0.5` for `.5`; none where nothing is near.
pub fn nearest_number(text: &str) -> Option<String> {
    let text = text.trim();
    let lower = text.to_ascii_lowercase();
    let bare = lower.trim_start_matches(['+', '-']);
    let sign = if text.starts_with('-') { "-" } else { "" };
    if let Some(digits) = bare.strip_prefix("0x") {
        return u64::from_str_radix(digits, 16).ok().map(|number| format!("{sign}{number}"));
    }
    // What the usual reader of numbers takes is near enough.
    text.parse::<f64>().ok()?;
    let (mantissa, exponent) = match bare.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, format!("e{exponent}")),
        None => (bare, String::new()),
    };
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let before = before.trim_start_matches('0');
    let before = if before.is_empty() { "0" } else { before };
    let after = if after.is_empty() { String::new() } else { format!(".{after}") };
    let number = format!("{sign}{before}{after}{exponent}");
    is_number(&number).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decimals near ties of singles, at the ends of their range, and long ones.
    const HARD: [&str; 22] = [
        "1.00000005960464477540",
        "1.00000005960464477539062500000000000000000000000000000000001",
        "1.000000059604644775390625",
        "1.00000005960464477539062499999999999999999999999999999999999",
        "-1.00000017881393432617187499999999999999999999999999",
        "-1.00000017881393432617187500000000000000000000000001",
        "3.4028235677973366e38",
        "340282356779733661637539395458142568447.9999",
        "1e-46",
        "7.0064923216240853546186479164495806564013097093825788587853e-46",
        "7.0064923216240853546186479164495806564013097093825788587855e-46",
        "1.1754943157898258998483097e-38",
        "-0",
        "-0.0e7",
        "0.1",
        "16777217.0000000000000000000000000000000001",
        "16777217",
        "16777216.9999999999999999999999999999999999",
        "123456789.123456789e-5",
        "1e38",
        "1E+2",
        "5e-324",
    ];

    #[test]
    fn a_double_rounds_to_the_single() {
        for text in HARD {
            let once = text.parse::<f32>().unwrap();
            assert_eq!(single(text).map(f32::to_bits), Some(once.to_bits()), "{text}");
            let double = double(text).unwrap();
            assert_eq!((double as f32).to_bits(), once.to_bits(), "{text}");
            let nearest = text.parse::<f64>().unwrap();
            assert!([nearest.next_down(), nearest, nearest.next_up()].contains(&double), "{text}");
        }
        assert_eq!(single("1.00000005960464477540"), Some(1.000_000_1));
        assert_eq!(single("3.4028235677973366e38"), Some(f32::MAX));
        assert_eq!(single("3.4028235677973367e38"), None);
        assert_eq!(double("1e39"), Some(1e39));
        assert_eq!((single("1e39"), double("1e400")), (None, None));
    }

    #[test]
    fn the_grammar_is_that_of_json() {
        for text in ["0", "-0", "10", "0.5", "1e5", "1E-5", "-1.25e+05", "1e00"] {
            assert!(is_number(text), "{text}");
        }
        for text in [
            "", "-", "+1", ".5", "1.", "01", "-01", "00", "0x10", "1e", "1e+", "NaN", "inf", "1 ",
            " 1", "1_000", "1.e5", "--1", "1e5.", "١", "infinity", "1f",
        ] {
            assert!(!is_number(text), "{text}");
            assert_eq!((single(text), double(text)), (None, None), "{text}");
            assert_eq!(whole(text), Whole::NoNumber, "{text}");
        }
    }

    #[test]
    fn whole_numbers_are_exact() {
        let number = |text: &str, number: i128| assert_eq!(whole(text), Whole::Number(number));
        number("0", 0);
        number("-0", 0);
        number("0.000e99999999999999999999", 0);
        number("2.0", 2);
        number("20e-1", 2);
        number("0.002e3", 2);
        number("-1.5e1", -15);
        number("18446744073709551615", u64::MAX.into());
        number("1.8446744073709551615e19", u64::MAX.into());
        number("9007199254740993", 9_007_199_254_740_993);
        number("1e99999999999999999999", i128::MAX);
        number("-1e999999999", i128::MIN);
        number("1e38", 10_i128.pow(38));
        for text in ["0.5", "1e-1", "15e-1", "2147483647.00000000000000001", "1e-99999999999999999"]
        {
            assert_eq!(whole(text), Whole::Fraction, "{text}");
        }
    }

    #[test]
    fn what_is_nearly_a_number_is_known() {
        for (text, number) in [
            (".5", "0.5"),
            ("-.5", "-0.5"),
            ("+1", "1"),
            ("007.", "7"),
            ("0x10", "16"),
            ("1.e5", "1e5"),
            (" 2 ", "2"),
        ] {
            assert_eq!(nearest_number(text).as_deref(), Some(number), "{text}");
        }
        for text in ["x", "", "NaN", "-inf", "0xg", "1,2"] {
            assert_eq!(nearest_number(text), None, "{text}");
        }
    }
}
