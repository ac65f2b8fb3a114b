//! Whole numbers for people.

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
}
