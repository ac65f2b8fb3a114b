//! Coarser versions of a picture.

use crate::film::{Film, SizeError};

/// Columns and rows of the version that is half as wide and high.
fn halved([width, height]: [u32; 2]) -> Option<[u32; 2]> {
    (width > 1 || height > 1).then(|| [(width / 2).max(1), (height / 2).max(1)])
}

/// How many pixels the coarser versions of a picture have together, down to the one of a single pixel:
/// a third of its own, and as many as its own where it is a single row.
pub(super) fn pixels(size: [u32; 2]) -> u64 {
    let sizes = std::iter::successors(halved(size), |size| halved(*size));
    sizes.map(|[width, height]| u64::from(width) * u64::from(height)).sum()
}

/// The coarser versions of a picture, each made from the one before, down to a single pixel. A pixel is
/// the mean of what it covers, parts of pixels by their area, so that each fills the very same 0 to
/// 1 and none reaches over an edge: how the picture is wrapped does not matter.
///
/// # Errors
/// There is not enough memory.
pub(super) fn coarser(film: &Film) -> Result<Vec<Film>, SizeError> {
    let mut levels: Vec<Film> = Vec::new();
    loop {
        let from = levels.last().unwrap_or(film);
        let Some([width, height]) = halved([from.width(), from.height()]) else {
            return Ok(levels);
        };
        let next = resampled(from, width, height)?;
        levels.push(next);
    }
}

fn resampled(from: &Film, width: u32, height: u32) -> Result<Film, SizeError> {
    let mut film = Film::new(width, height)?;
    for row in 0..height {
        for column in 0..width {
            let mut sum = [0.0_f64; 4];
            for (below, share_of_row) in covered(row, height, from.height()) {
                for (beside, share) in covered(column, width, from.width()) {
                    let color = from.pixel(beside, below);
                    for (sum, color) in sum.iter_mut().zip(color) {
                        *sum += f64::from(color) * (share * share_of_row);
                    }
                }
            }
            film.set(column, row, sum.map(|mean| mean as f32));
        }
    }
    Ok(film)
}

/// The pixels of `many` that lie under pixel `at` of `few`, each with its share.
fn covered(at: u32, few: u32, many: u32) -> impl Iterator<Item = (u32, f64)> {
    // In units of 1 / (few * many) of the whole, which are whole numbers.
    let (few, many) = (u64::from(few), u64::from(many));
    let (from, to) = (u64::from(at) * many, (u64::from(at) + 1) * many);
    (from / few..to.div_ceil(few)).map(move |pixel| {
        let common = to.min((pixel + 1) * few) - from.max(pixel * few);
        (pixel as u32, common as f64 / many as f64)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(width: u32, height: u32, color: impl Fn(u32, u32) -> f32) -> Film {
        let mut film = Film::new(width, height).unwrap();
        for row in 0..height {
            for column in 0..width {
                film.set(column, row, [color(column, row), 0.5, 0.0, 1.0]);
            }
        }
        film
    }

    #[test]
    fn a_pixel_is_the_mean_of_what_it_covers() {
        let levels = coarser(&film(4, 2, |column, row| (column + 4 * row) as f32)).unwrap();
        let sizes: Vec<_> = levels.iter().map(|level| [level.width(), level.height()]).collect();
        assert_eq!(sizes, [[2, 1], [1, 1]]);
        assert_eq!(levels[0].pixels(), [[2.5, 0.5, 0.0, 1.0], [4.5, 0.5, 0.0, 1.0]]);
        assert_eq!(levels[1].pixels(), [[3.5, 0.5, 0.0, 1.0]]);
    }

    #[test]
    fn an_odd_picture_keeps_its_mean_and_its_edges() {
        let levels = coarser(&film(5, 1, |column, _| column as f32)).unwrap();
        // Each of two covers two and a half of five.
        let red: Vec<f32> = levels[0].pixels().iter().map(|pixel| pixel[0]).collect();
        assert_eq!(red, [0.8, 3.2]);
        assert_eq!(levels[1].pixels()[0][0], 2.0);
        let shares: f64 = covered(1, 3, 7).map(|(_, share)| share).sum();
        assert!((shares - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_they_take_is_known_beforehand() {
        for size in [[1, 1], [2, 2], [5, 3], [64, 1], [7, 130]] {
            let levels = coarser(&film(size[0], size[1], |_, _| 0.0)).unwrap();
            let held: usize = levels.iter().map(|level| level.pixels().len()).sum();
            assert_eq!(held as u64, pixels(size), "{size:?}");
        }
        // Ten halvings to a row of 64, then six to one pixel.
        assert_eq!(pixels([65_536, 1_024]), 22_369_600 + 63);
    }
}
