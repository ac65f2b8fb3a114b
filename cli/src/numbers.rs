//! 32-bit numbers as text that reads back to the same bits.

use serde_json::Value;

/// The shortest JSON number that reads back to `x`; JSON has none for what is not finite, which
/// becomes the string `"NaN"`, `"inf"` or `"-inf"`.
pub fn number(x: f32) -> Value {
    if !x.is_finite() {
        return Value::from(x.to_string());
    }
    // Through the decimal digits of the f32: as an f64, 0.1 would get seventeen of them.
    x.to_string().parse::<f64>().map_or(Value::Null, Value::from)
}

/// The shortest decimal text that reads back to `x`.
pub fn digits(x: f32) -> String {
    let magnitude = x.abs();
    if magnitude != 0.0 && magnitude.is_finite() && !(1e-5..1e9).contains(&magnitude) {
        format!("{x:e}")
    } else {
        x.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HARD: [f32; 11] = [
        0.1,
        -0.0,
        1e-45,
        f32::MIN_POSITIVE,
        f32::MAX,
        f32::MIN,
        1.0 + f32::EPSILON,
        1.0 - f32::EPSILON / 2.0,
        16_777_217.0,
        1e-5,
        1e9,
    ];

    #[test]
    fn digits_read_back_to_the_same_bits() {
        for x in HARD {
            assert_eq!(digits(x).parse::<f32>().map(f32::to_bits), Ok(x.to_bits()), "{x:e}");
            let json = number(x).to_string();
            assert_eq!(json.parse::<f32>().map(f32::to_bits), Ok(x.to_bits()), "{json}");
            let read = serde_json::from_str::<f64>(&json).map(|read| (read as f32).to_bits());
            assert_eq!(read.ok(), Some(x.to_bits()), "{json}");
        }
        assert_eq!(number(0.1).to_string(), "0.1");
        assert_eq!(number(-0.0).to_string(), "-0.0");
    }

    #[test]
    fn what_is_not_finite_is_named() {
        assert_eq!(number(f32::NAN), "NaN");
        assert_eq!(number(f32::NEG_INFINITY), "-inf");
        assert_eq!(digits(f32::INFINITY), "inf");
    }
}
