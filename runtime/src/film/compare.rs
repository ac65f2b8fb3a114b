//! How much two pictures differ.

use serde::Serialize;

use super::buffer::Film;
use super::encoding::srgb_encoded;
use super::size::SizeError;

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
    /// Of the values as they are. A number against what is none differs infinitely.
    pub raw: Difference,
    /// Of alpha, as it is.
    pub alpha: Difference,
    /// Whether all four channels have the same bits everywhere, any NaN being like any other.
    pub identical: bool,
    /// Pixels of which a channel is NaN or infinite, and not the same in both pictures.
    pub not_finite: u64,
    /// The first value of them, in rows from the top left.
    pub first_not_finite: Option<NotFinite>,
}

/// A value that is NaN or infinite in one picture, and something else in the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFinite {
    /// From the left, 0 first.
    pub column: u32,
    /// From the top, 0 first.
    pub row: u32,
    /// 0 to 3: red, green, blue and alpha.
    pub channel: usize,
    /// What the two pictures have.
    pub values: [f32; 2],
}

/// Why pictures cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CompareError {
    /// They have different sizes.
    #[error("the pictures have different sizes: {} x {} and {} x {}", first.0, first.1, second.0, second.1)]
    SizesDiffer {
        /// Width and height of the first.
        first: (u32, u32),
        /// Width and height of the second.
        second: (u32, u32),
    },
    /// There is not enough memory for a picture of the differences.
    #[error(transparent)]
    Size(#[from] SizeError),
}

/// Compares two pictures of one size.
///
/// # Errors
/// They have different sizes.
pub fn compare(first: &Film, second: &Film) -> Result<Comparison, CompareError> {
    require_one_size(first, second)?;
    let (mut encoded, mut raw, mut alpha) = (Sum::default(), Sum::default(), Sum::default());
    let mut identical = true;
    let (mut not_finite, mut first_not_finite) = (0, None);
    for (at, (a, b)) in first.pixels().iter().zip(second.pixels()).enumerate() {
        identical &= (0..4).all(|k| same(a[k], b[k]));
        for k in 0..3 {
            encoded.add(f64::from((srgb_encoded(a[k]) - srgb_encoded(b[k])).abs()));
            raw.add(difference(a[k], b[k]));
        }
        alpha.add(difference(a[3], b[3]));
        let finite = |k: usize| a[k].is_finite() && b[k].is_finite();
        let unlike = |k: &usize| !(same(a[*k], b[*k]) || finite(*k));
        if let Some(channel) = (0..4).find(unlike) {
            not_finite += 1;
            let width = first.width() as usize;
            let (column, row) = ((at % width) as u32, (at / width) as u32);
            let values = [a[channel], b[channel]];
            first_not_finite.get_or_insert(NotFinite { column, row, channel, values });
        }
    }
    Ok(Comparison {
        encoded: encoded.difference(),
        raw: raw.difference(),
        alpha: alpha.difference(),
        identical,
        not_finite,
        first_not_finite,
    })
}

/// The absolute differences of the encoded values of red, green and blue, to be looked at; alpha 1.
///
/// # Errors
/// The pictures have different sizes, or there is not enough memory.
pub fn difference_picture(first: &Film, second: &Film) -> Result<Film, CompareError> {
    require_one_size(first, second)?;
    let mut picture = Film::new(first.width(), first.height())?;
    let pairs = first.pixels().iter().zip(second.pixels());
    for (shown, (a, b)) in picture.pixels_mut().iter_mut().zip(pairs) {
        let difference = |k: usize| (srgb_encoded(a[k]) - srgb_encoded(b[k])).abs();
        *shown = [difference(0), difference(1), difference(2), 1.0];
    }
    Ok(picture)
}

fn require_one_size(first: &Film, second: &Film) -> Result<(), CompareError> {
    let [first, second] = [first, second].map(|film| (film.width(), film.height()));
    if first == second { Ok(()) } else { Err(CompareError::SizesDiffer { first, second }) }
}

/// How far two values are apart: infinitely where one is no number and the other is, or another.
fn difference(a: f32, b: f32) -> f64 {
    if same(a, b) { 0.0 } else { (f64::from(a) - f64::from(b)).abs() }
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
    fn what_is_not_finite_must_be_the_same_in_both() {
        let hard = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.5, f32::MAX];
        for (i, a) in hard.into_iter().enumerate() {
            for (j, b) in hard.into_iter().enumerate() {
                let comparison = compare(&film(a), &film(b)).unwrap();
                let unlike = i != j && (i < 3 || j < 3);
                assert_eq!(comparison.not_finite, u64::from(unlike), "{a} {b}");
                assert_eq!(comparison.first_not_finite.is_some(), unlike, "{a} {b}");
                assert_eq!(comparison.raw.maximum.is_infinite(), unlike, "{a} {b}");
            }
        }
        let (mut a, mut b) = (Film::new(3, 2).unwrap(), Film::new(3, 2).unwrap());
        // A NaN of another payload and sign is the same.
        a.set(0, 0, [f32::NAN; 4]);
        b.set(0, 0, [f32::from_bits(0xffc0_0123); 4]);
        a.set(1, 1, [0.0, 0.0, 0.0, f32::INFINITY]);
        b.set(2, 1, [f32::NAN, f32::NAN, 0.0, 0.0]);
        let comparison = compare(&a, &b).unwrap();
        let values = [f32::INFINITY, 0.0];
        let first = NotFinite { column: 1, row: 1, channel: 3, values };
        assert_eq!((comparison.not_finite, comparison.first_not_finite), (2, Some(first)));
        assert_eq!(comparison.encoded, Difference::default());
        assert_eq!(comparison.alpha.maximum, f64::INFINITY);
        assert!(compare(&a, &a).unwrap().identical);
    }

    #[test]
    fn small_differences_beside_large_ones_are_not_lost() {
        let side = 1024;
        let (mut a, b) = (Film::new(side, side).unwrap(), Film::new(side, side).unwrap());
        a.pixels_mut().fill([1e-4, 0.0, 0.0, 0.0]);
        a.set(0, 0, [100.0, 0.0, 0.0, 0.0]);
        let count = f64::from(side) * f64::from(side);
        let small = f64::from(1e-4_f32);
        let exact = ((1e4 + (count - 1.0) * small * small) / (3.0 * count)).sqrt();
        let rms = compare(&a, &b).unwrap().raw.rms;
        assert!((rms / exact - 1.0).abs() < 1e-9, "{rms:e} {exact:e}");
        // 32 bits would have kept the large one alone.
        assert!(rms / (1e4 / (3.0 * count)).sqrt() > 1.0 + 1e-7);
    }

    #[test]
    fn the_picture_shows_what_a_screen_would() {
        let picture = difference_picture(&film(7.0), &film(f32::NAN)).unwrap();
        assert_eq!(picture.pixel(0, 0), [1.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn sizes_must_agree() {
        let wide = Film::new(3, 1).unwrap();
        let error = CompareError::SizesDiffer { first: (3, 1), second: (2, 1) };
        assert_eq!(compare(&wide, &film(0.0)), Err(error));
        assert_eq!(difference_picture(&wide, &film(0.0)), Err(error));
    }
}
