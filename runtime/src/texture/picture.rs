//! One picture, read between its pixels.

use phenomenon_compiler::effects::{Filter, Lookup, Sampling, Wrap};

use super::footprint::Probes;
use super::{levels, wrap};
use crate::film::{Film, SizeError};

/// Scene-linear pixels that fill 0..1 in both coordinates, and coarser versions once they are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    film: Film,
    coarser: Option<Vec<Film>>,
}

impl Picture {
    /// A picture of these pixels, the top row first.
    pub fn new(film: Film) -> Self {
        Self { film, coarser: None }
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        [self.film.width(), self.film.height()]
    }

    /// Whether it has its coarser versions.
    pub(super) fn has_levels(&self) -> bool {
        self.coarser.is_some()
    }

    /// Makes the coarser versions that footprints are read from.
    ///
    /// # Errors
    /// There is not enough memory.
    pub(super) fn make_levels(&mut self) -> Result<(), SizeError> {
        self.coarser = Some(levels::coarser(&self.film)?);
        Ok(())
    }

    /// The colour (r, g, b, a) at a place, `u` from the left and `v` from the bottom; none where a
    /// coordinate is not finite. Footprints are read from the coarser versions there are.
    pub fn color(&self, sampling: Sampling, lookup: &Lookup) -> Option<[f32; 4]> {
        let Lookup { uv, default, footprint } = *lookup;
        if !uv.iter().all(|x| x.is_finite()) {
            return None;
        }
        let at = uv.map(f64::from);
        let pixels = Pixels { film: &self.film, wrap: sampling.wrap, default };
        Some(match sampling.filter {
            Filter::Linear => pixels.linear(at),
            Filter::Closest => pixels.closest(at),
            Filter::Cubic => pixels.cubic(at),
            Filter::Footprint => self.covered(pixels, at, Probes::of(footprint, self.size())),
        })
    }

    /// The mean of what probes cover, each bilinear in two levels and between them.
    fn covered(&self, pixels: Pixels<'_>, at: [f64; 2], probes: Probes) -> [f32; 4] {
        let coarser = self.coarser.as_deref().unwrap_or_default();
        let level = probes.level.min(coarser.len() as f64);
        let whole = level.floor();
        let film = |number: usize| match number.checked_sub(1) {
            Some(number) => &coarser[number],
            None => &self.film,
        };
        let fine = Pixels { film: film(whole as usize), ..pixels };
        let weight = (level - whole) as f32;
        let coarse = (weight > 0.0).then(|| Pixels { film: film(whole as usize + 1), ..pixels });
        let mut sum = [0.0_f32; 4];
        for probe in 0..probes.count {
            let steps = f64::from(probe) - f64::from(probes.count - 1) / 2.0;
            let at = [0, 1].map(|axis| at[axis] + probes.step[axis] * steps);
            let color = fine.linear(at);
            let color = match coarse {
                Some(coarse) => blended(color, coarse.linear(at), weight),
                None => color,
            };
            for (sum, color) in sum.iter_mut().zip(color) {
                *sum += color;
            }
        }
        match probes.count {
            1 => sum,
            count => sum.map(|sum| sum / count as f32),
        }
    }
}

/// The pixels of a film, and what lies beyond them.
#[derive(Clone, Copy)]
struct Pixels<'a> {
    film: &'a Film,
    wrap: [Wrap; 2],
    default: [f32; 4],
}

impl Pixels<'_> {
    /// The pixel at a column from the left and a row from the bottom.
    fn at(self, column: i64, row: i64) -> [f32; 4] {
        let (width, height) = (self.film.width(), self.film.height());
        let column = wrap::pixel(column, width, self.wrap[0]);
        match (column, wrap::pixel(row, height, self.wrap[1])) {
            // Coordinates rise, rows fall.
            (Some(column), Some(row)) => self.film.pixel(column, height - 1 - row),
            _ => self.default,
        }
    }

    /// Where a place lies, in pixels from the left and from below.
    fn position(self, at: [f64; 2]) -> [f64; 2] {
        let size = [self.film.width(), self.film.height()];
        [0, 1].map(|axis| wrap::position(at[axis], size[axis], self.wrap[axis]))
    }

    fn closest(self, at: [f64; 2]) -> [f32; 4] {
        let [across, up] = self.position(at);
        self.at(across.floor() as i64, up.floor() as i64)
    }

    fn linear(self, at: [f64; 2]) -> [f32; 4] {
        let [(left, across), (below, up)] = self.position(at).map(from_middle);
        let bottom = blended(self.at(left, below), self.at(left + 1, below), across);
        let top = blended(self.at(left, below + 1), self.at(left + 1, below + 1), across);
        blended(bottom, top, up)
    }

    fn cubic(self, at: [f64; 2]) -> [f32; 4] {
        let [(left, across), (below, up)] = self.position(at).map(from_middle);
        let (of_columns, of_rows) = (spline(across), spline(up));
        let mut sum = [0.0_f32; 4];
        for (row, of_row) in (below - 1..).zip(of_rows) {
            for (column, of_column) in (left - 1..).zip(of_columns) {
                let color = self.at(column, row);
                for (sum, color) in sum.iter_mut().zip(color) {
                    *sum += color * (of_column * of_row);
                }
            }
        }
        sum
    }
}

/// The pixel whose middle is the next at or before a position, and how far the position is from there to the
/// next one.
fn from_middle(position: f64) -> (i64, f32) {
    let position = position - 0.5;
    let first = position.floor();
    (first as i64, (position - first) as f32)
}

/// Weights of four pixels by the uniform cubic B-spline, for a place between the two in the middle. None is
/// negative, and their sum is 1.
fn spline(t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    let inner = |near: f32| (4.0 - near * near * (6.0 - 3.0 * near)) / 6.0;
    [s * s * s / 6.0, inner(t), inner(s), t * t * t / 6.0]
}

/// Exactly the one or the other at the ends, and never outside both between them.
fn blended(from: [f32; 4], to: [f32; 4], weight: f32) -> [f32; 4] {
    std::array::from_fn(|k| from[k] * (1.0 - weight) + to[k] * weight)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINEAR: Sampling = Sampling { wrap: [Wrap::Periodic; 2], filter: Filter::Linear };

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

    fn read(picture: &Picture, sampling: Sampling, uv: [f32; 2]) -> Option<[f32; 4]> {
        let default = [9.0, 8.0, 7.0, 1.0];
        picture.color(sampling, &Lookup { uv, default, ..Lookup::default() })
    }

    fn linear(picture: &Picture, uv: [f32; 2]) -> Option<[f32; 4]> {
        read(picture, LINEAR, uv)
    }

    fn middle(column: i32, row: i32) -> [f32; 2] {
        [(column as f32 + 0.5) / 3.0, 1.0 - (row as f32 + 0.5) / 2.0]
    }

    #[test]
    fn the_first_coordinate_runs_right_and_the_second_up() {
        let picture = picture();
        for filter in [Filter::Linear, Filter::Closest, Filter::Footprint] {
            for (row, column) in (0..2).flat_map(|row| (0..3).map(move |column| (row, column))) {
                let sampling = Sampling { filter, ..LINEAR };
                let [r, g, b, a] = read(&picture, sampling, middle(column, row)).unwrap();
                assert!((r - column as f32).abs() < 1e-6 && (g - row as f32).abs() < 1e-6);
                assert_eq!([b, a], [0.25, 0.5]);
            }
        }
        assert!((linear(&picture, [1.0 / 3.0, 0.75]).unwrap()[0] - 0.5).abs() < 1e-6);
    }

    #[test]
    fn it_repeats_without_a_seam() {
        let picture = picture();
        for [u, v] in [[0.1, 0.2], [0.0, 0.0], [0.999, 0.5]] {
            let inside = linear(&picture, [u, v]).unwrap();
            for (du, dv) in [(1.0, 0.0), (-2.0, 3.0), (0.0, -1.0)] {
                let outside = linear(&picture, [u + du, v + dv]).unwrap();
                let close = inside.iter().zip(outside).all(|(a, b)| (a - b).abs() < 1e-5);
                assert!(close, "{u} {v} {du} {dv}: {inside:?} {outside:?}");
            }
        }
        // Halfway between the last column and the first.
        assert_eq!(linear(&picture, [0.0, 0.75]).unwrap()[0], 1.0);
        assert_eq!(linear(&picture, [-0.0, 0.75]), linear(&picture, [1.0, 0.75]));
    }

    #[test]
    fn beyond_the_edges_lies_what_was_chosen_for_the_axis() {
        let picture = picture();
        let red = |wrap, filter, column: i32| {
            let sampling = Sampling { wrap: [wrap, Wrap::Periodic], filter };
            read(&picture, sampling, middle(column, 0)).unwrap()[0]
        };
        for filter in [Filter::Linear, Filter::Closest, Filter::Footprint] {
            let row = |wrap| [-2, -1, 0, 2, 3, 4].map(|column| red(wrap, filter, column).round());
            assert_eq!(row(Wrap::Periodic), [1.0, 2.0, 0.0, 2.0, 0.0, 1.0]);
            assert_eq!(row(Wrap::Clamp), [0.0, 0.0, 0.0, 2.0, 2.0, 2.0]);
            assert_eq!(row(Wrap::Mirror), [1.0, 0.0, 0.0, 2.0, 2.0, 1.0]);
            assert_eq!(row(Wrap::Constant), [9.0, 9.0, 0.0, 2.0, 9.0, 9.0]);
        }
        // Half of the edge is the picture's outermost pixel, half what lies beyond.
        let edge = |wrap| {
            read(&picture, Sampling { wrap: [wrap, Wrap::Clamp], ..LINEAR }, [1.0, 0.75]).unwrap()
                [0]
        };
        assert_eq!([Wrap::Clamp, Wrap::Mirror, Wrap::Periodic].map(edge), [2.0, 2.0, 1.0]);
        assert_eq!(edge(Wrap::Constant), 5.5);
        // The axes have modes of their own.
        let corner = Sampling { wrap: [Wrap::Clamp, Wrap::Constant], filter: Filter::Closest };
        assert_eq!(read(&picture, corner, [7.0, 0.75]).unwrap()[0], 2.0);
        assert_eq!(read(&picture, corner, [0.5, 7.0]).unwrap()[0], 9.0);
    }

    #[test]
    fn a_spline_blurs_and_stays_within_the_pixels() {
        for t in [0.0, 0.25, 0.5, 0.999_999_94] {
            let weights = spline(t);
            assert!(weights.iter().all(|weight| *weight >= 0.0));
            assert!((weights.iter().sum::<f32>() - 1.0).abs() < 2e-7);
        }
        assert_eq!(spline(0.0), [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0]);
        let cubic = Sampling { wrap: [Wrap::Clamp; 2], filter: Filter::Cubic };
        let [r, _, b, a] = read(&picture(), cubic, middle(1, 0)).unwrap();
        assert!((r - 1.0).abs() < 1e-6 && (b - 0.25).abs() < 1e-6 && (a - 0.5).abs() < 1e-6);
        let [r, ..] = read(&picture(), cubic, middle(0, 0)).unwrap();
        assert!((r - 1.0 / 6.0).abs() < 1e-6, "{r}");
    }

    #[test]
    fn a_footprint_averages_what_it_covers() {
        // Columns of black and white.
        let mut film = Film::new(8, 8).unwrap();
        for row in 0..8 {
            for column in 0..8 {
                film.set(column, row, [(column % 2) as f32, row as f32, 0.0, 1.0]);
            }
        }
        let mut picture = Picture::new(film);
        picture.make_levels().unwrap();
        let color = |wrap, uv, footprint| {
            let sampling = Sampling { wrap: [wrap; 2], filter: Filter::Footprint };
            picture.color(sampling, &Lookup { uv, footprint, ..Lookup::default() }).unwrap()
        };
        for wrap in [Wrap::Periodic, Wrap::Clamp, Wrap::Mirror] {
            // Two columns wide and any height: grey, and the row it is in.
            let [grey, row, ..] = color(wrap, [0.51, 0.3125], [[0.25, 0.0], [0.0, 0.125]]);
            assert!((grey - 0.5).abs() < 0.02 && (row - 5.0).abs() < 1e-5, "{wrap:?} {grey} {row}");
            // All of it, from anywhere.
            for at in [-3.7, 0.2, 9.1] {
                let [grey, row, ..] = color(wrap, [at, 0.4], [[4.0, 0.0], [0.0, 4.0]]);
                assert!((grey - 0.5).abs() < 1e-5 && (row - 3.5).abs() < 1e-5, "{grey} {row}");
            }
        }
        // Beyond a constant border, half of what is seen at the edge.
        let [.., alpha] = color(Wrap::Constant, [1.0, 0.5], [[0.25, 0.0], [0.0, 0.25]]);
        assert!((alpha - 0.5).abs() < 1e-5, "{alpha}");
    }

    #[test]
    fn hard_coordinates_have_a_colour_or_none() {
        let mut picture = picture();
        picture.make_levels().unwrap();
        for filter in [Filter::Linear, Filter::Closest, Filter::Cubic, Filter::Footprint] {
            for wrap in [Wrap::Periodic, Wrap::Clamp, Wrap::Mirror] {
                let sampling = Sampling { wrap: [wrap; 2], filter };
                for x in [1e-45, -1e-45, f32::MAX, f32::MIN, 16_777_217.0] {
                    let lookup = Lookup {
                        uv: [x, x],
                        footprint: [[x, 0.0], [f32::NAN, f32::INFINITY]],
                        ..Lookup::default()
                    };
                    let [r, g, ..] = picture.color(sampling, &lookup).unwrap();
                    let inside = (0.0..=2.000_001).contains(&r) && (0.0..=1.000_001).contains(&g);
                    assert!(inside, "{sampling:?} {x}: {r} {g}");
                }
                for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                    assert_eq!(read(&picture, sampling, [x, 0.5]), None);
                    assert_eq!(read(&picture, sampling, [0.5, x]), None);
                }
            }
        }
    }

    #[test]
    fn one_pixel_is_the_same_everywhere() {
        let mut film = Film::new(1, 1).unwrap();
        film.set(0, 0, [0.1, 0.2, 0.3, 0.4]);
        let picture = Picture::new(film);
        for x in [0.0, 0.3, 0.5, 7.75] {
            let color = linear(&picture, [x, -x]).unwrap();
            assert!(color.iter().zip([0.1, 0.2, 0.3, 0.4]).all(|(a, b)| (a - b).abs() < 1e-7));
        }
    }
}
