//! How much two pictures differ.

use serde::Serialize;

use super::buffer::Film;
use super::encoding::srgb_encoded;

/// Root mean square and maximum of the differences of red, green and blue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Root mean square.
    pub rms: f64,
    /// Maximum.
    pub maximum: f64,
}

/// What a comparison found.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Of the values as a screen shows them: sRGB-encoded and clamped to 0..=1.
    pub encoded: Difference,
    /// Of the values as they are.
    pub raw: Difference,
    /// Whether all four channels have the same bits everywhere, any NaN being like any other.
    pub identical: bool,
    /// Absolute differences of the encoded values, to be looked at; alpha 1.
    pub picture: Film,
}

/// The pictures have different sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the pictures have different sizes: {} x {} and {} x {}", first.0, first.1, second.0, second.1)]
pub struct SizesDiffer {
    /// Width and height of the first.
    pub first: (u32, u32),
    /// Width and height of the second.
    pub second: (u32, u32),
}

/// Compares two pictures of one size.
pub fn compare(first: &Film, second: &Film) -> Result<Comparison, SizesDiffer> {
    let sizes = [first, second].map(|film| (film.width(), film.height()));
    if sizes[0] != sizes[1] {
        return Err(SizesDiffer { first: sizes[0], second: sizes[1] });
    }
    let mut picture = first.clone();
    let (mut encoded, mut raw) = (Sum::default(), Sum::default());
    let mut identical = true;
    for row in 0..first.height() {
        for column in 0..first.width() {
            let (a, b) = (first.pixel(column, row), second.pixel(column, row));
            identical &= (0..4).all(|k| same(a[k], b[k]));
            let mut shown = [0.0, 0.0, 0.0, 1.0];
            for k in 0..3 {
                let difference = srgb_encoded(a[k]) - srgb_encoded(b[k]);
                shown[k] = difference.abs();
                encoded.add(f64::from(difference.abs()));
                raw.add(match same(a[k], b[k]) {
                    true => 0.0,
                    false => (f64::from(a[k]) - f64::from(b[k])).abs(),
                });
            }
            picture.set(column, row, shown);
        }
    }
    Ok(Comparison { encoded: encoded.difference(), raw: raw.difference(), identical, picture })
}

fn same(a: f32, b: f32) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[derive(Default)]
struct Sum {
    squares: f64,
    maximum: f64,
    count: u64,
}

impl Sum {
    /// Adds an absolute difference; NaN, a number against none, counts as infinite.
    fn add(&mut self, difference: f64) {
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        self.squares += difference * difference;
        self.maximum = self.maximum.max(difference);
        self.count += 1;
    }

    fn difference(&self) -> Difference {
        let rms = (self.squares / self.count.max(1) as f64).sqrt();
        Difference { rms, maximum: self.maximum }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(value: f32) -> Film {
        let mut film = Film::new(2, 1).unwrap();
        film.set(0, 0, [value, 0.5, 0.5, 1.0]);
        film
    }

    #[test]
    fn equal_pictures_differ_by_nothing() {
        for value in [0.3, f32::NAN, f32::INFINITY] {
            let comparison = compare(&film(value), &film(value)).unwrap();
            assert!(comparison.identical);
            assert_eq!(comparison.raw, Difference::default());
            assert_eq!(comparison.encoded, Difference::default());
        }
    }

    #[test]
    fn above_white_only_the_raw_values_differ() {
        let comparison = compare(&film(2.0), &film(5.0)).unwrap();
        assert_eq!(comparison.encoded.maximum, 0.0);
        assert_eq!(comparison.raw.maximum, 3.0);
        assert_eq!(comparison.raw.rms, (9.0_f64 / 6.0).sqrt());
        assert!(!comparison.identical);
    }

    #[test]
    fn a_number_against_nan_is_as_different_as_can_be() {
        let comparison = compare(&film(f32::NAN), &film(0.0)).unwrap();
        assert_eq!(comparison.raw.maximum, f64::INFINITY);
        assert!(!compare(&film(0.0), &film(-0.0)).unwrap().identical);
    }

    #[test]
    fn sizes_must_agree() {
        let wide = Film::new(3, 1).unwrap();
        assert_eq!(compare(&wide, &film(0.0)).unwrap_err().first, (3, 1));
    }
}
