//! Numbers for people.

/// A whole number, its digits in groups of three: `1,234,567`.
pub fn grouped<N: Into<i128>>(number: N) -> String {
    let number: i128 = number.into();
    let digits = number.unsigned_abs().to_string();
    let mut text = String::from(if number < 0 { "-" } else { "" });
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A number of a range; one of very many digits, or of very many noughts, with its exponent: `1.7e38`.
pub fn rounded(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-6..1e15).contains(&size) || !size.is_finite() {
        return number.to_string();
    }
    let single = number as f32;
    let is_normal = single.is_normal();
    if is_normal { format!("{single:e}") } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_grouped() {
        let numbers = [0, 999, 1000, 12_345_678, -1_234_567, -999];
        let expected = ["0", "999", "1,000", "12,345,678", "-1,234,567", "-999"];
        assert_eq!(numbers.map(grouped::<i32>), expected);
        assert_eq!(grouped(u64::MAX), "18,446,744,073,709,551,615");
    }

    #[test]
    fn very_large_and_small_numbers_have_exponents() {
        let numbers = [0.0, -1.5, 2_147_483_647.0, 1.7e38, -1e-30, 1e300, 1e-300, 0.1];
        let expected = ["0", "-1.5", "2147483647", "1.7e38", "-1e-30", "1e300", "1e-300", "0.1"];
        assert_eq!(numbers.map(rounded), expected);
    }
}
