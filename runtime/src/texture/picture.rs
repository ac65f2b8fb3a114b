//! One picture, read between its pixels.

use crate::film::Film;

/// Scene-linear pixels that fill 0..1 in both coordinates and repeat outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    film: Film,
}

impl Picture {
    /// A picture of these pixels, the top row first.
    pub fn new(film: Film) -> Self {
        Self { film }
    }

    /// The colour (r, g, b, a) at `u` from the left and `v` from the bottom, bilinear between the
    /// middles of pixels; none where a coordinate is not finite.
    pub fn color(&self, [u, v]: [f32; 2]) -> Option<[f32; 4]> {
        if !u.is_finite() || !v.is_finite() {
            return None;
        }
        let (left, right, across) = neighbours(u, self.film.width());
        // Coordinates rise, rows fall.
        let (below, above, up) = neighbours(v, self.film.height());
        let last = self.film.height() - 1;
        let at = |column: u32, row: u32| self.film.pixel(column, last - row);
        let bottom = blended(at(left, below), at(right, below), across);
        let top = blended(at(left, above), at(right, above), across);
        Some(blended(bottom, top, up))
    }
}

/// The two pixels round a coordinate, of `count` that repeat, and how far it is from the first to the
/// second. In f64, where the position among 65,536 pixels keeps the 24 bits of the coordinate.
fn neighbours(coordinate: f32, count: u32) -> (u32, u32, f32) {
    let whole = f64::from(coordinate);
    let position = (whole - whole.floor()) * f64::from(count) - 0.5;
    let first = position.floor();
    let column = (first as i64).rem_euclid(i64::from(count)) as u32;
    (column, (column + 1) % count, (position - first) as f32)
}

/// Exactly the one or the other at the ends, and never outside both between them.
fn blended(from: [f32; 4], to: [f32; 4], weight: f32) -> [f32; 4] {
    std::array::from_fn(|k| from[k] * (1.0 - weight) + to[k] * weight)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three by two pixels: column in red, row from the top in green.
    fn picture() -> Picture {
        let mut film = Film::new(3, 2).unwrap();
        for row in 0..2 {
            for column in 0..3 {
                film.set(column, row, [column as f32, row as f32, 0.25, 0.5]);
            }
        }
        Picture::new(film)
    }

    #[test]
    fn the_first_coordinate_runs_right_and_the_second_up() {
        let picture = picture();
        let middle =
            |column: u32, row: u32| [(column as f32 + 0.5) / 3.0, 1.0 - (row as f32 + 0.5) / 2.0];
        for row in 0..2 {
            for column in 0..3 {
                let [r, g, b, a] = picture.color(middle(column, row)).unwrap();
                assert!((r - column as f32).abs() < 1e-6 && (g - row as f32).abs() < 1e-6);
                assert_eq!([b, a], [0.25, 0.5]);
            }
        }
        assert!((picture.color([1.0 / 3.0, 0.75]).unwrap()[0] - 0.5).abs() < 1e-6);
    }

    #[test]
    fn it_repeats_without_a_seam() {
        let picture = picture();
        for [u, v] in [[0.1, 0.2], [0.0, 0.0], [0.999, 0.5]] {
            let inside = picture.color([u, v]).unwrap();
            for (du, dv) in [(1.0, 0.0), (-2.0, 3.0), (0.0, -1.0)] {
                let outside = picture.color([u + du, v + dv]).unwrap();
                let close = inside.iter().zip(outside).all(|(a, b)| (a - b).abs() < 1e-5);
                assert!(close, "{u} {v} {du} {dv}: {inside:?} {outside:?}");
            }
        }
        // Halfway between the last column and the first.
        assert_eq!(picture.color([0.0, 0.75]).unwrap()[0], 1.0);
        assert_eq!(picture.color([-0.0, 0.75]), picture.color([1.0, 0.75]));
    }

    #[test]
    fn hard_coordinates_have_a_colour_or_none() {
        let picture = picture();
        for x in [1e-45, -1e-45, f32::MAX, f32::MIN, 16_777_217.0] {
            let [r, g, ..] = picture.color([x, x]).unwrap();
            assert!((0.0..=2.0).contains(&r) && (0.0..=1.0).contains(&g), "{x}: {r} {g}");
        }
        for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(picture.color([x, 0.5]), None);
            assert_eq!(picture.color([0.5, x]), None);
        }
    }

    #[test]
    fn one_pixel_is_the_same_everywhere() {
        let mut film = Film::new(1, 1).unwrap();
        film.set(0, 0, [0.1, 0.2, 0.3, 0.4]);
        let picture = Picture::new(film);
        for x in [0.0, 0.3, 0.5, 7.75] {
            let color = picture.color([x, -x]).unwrap();
            assert!(color.iter().zip([0.1, 0.2, 0.3, 0.4]).all(|(a, b)| (a - b).abs() < 1e-7));
        }
    }
}
