//! How bright environments are in all directions.

use super::directions::DirectionTable;
use super::environment::EnvironmentImage;

/// Columns of the table of an environment that is no picture.
const COLUMNS: usize = 512;
/// Rows of it.
const ROWS: usize = 256;
/// Most columns of the table of a picture.
const MOST_COLUMNS: usize = 2048;
/// Most rows of it.
const MOST_ROWS: usize = 1024;
/// The share of directions that are drawn evenly where a table may miss light, being coarser than what it stands for.
const EVEN: f64 = 0.02;

/// The directions in which an environment that is no picture is looked at, row by row from the top: the middles of the cells.
pub(crate) fn looks() -> impl Iterator<Item = [f32; 3]> {
    use std::f32::consts::{PI, TAU};
    (0..ROWS * COLUMNS).map(|at| {
        let latitude = ((at / COLUMNS) as f32 + 0.5) / ROWS as f32 * PI;
        let longitude = (((at % COLUMNS) as f32 + 0.5) / COLUMNS as f32 - 0.5) * TAU;
        let (sine, height) = latitude.sin_cos();
        [sine * longitude.sin(), height, -sine * longitude.cos()]
    })
}

/// The table of what was seen in these directions.
pub(crate) fn seen(colors: &[[f32; 4]]) -> Option<DirectionTable> {
    let brightness: Vec<f32> = colors.iter().map(|color| luminance(*color)).collect();
    let at = |column: usize, row: usize| brightness[row * COLUMNS + column];
    let cells = (0..ROWS * COLUMNS).map(|cell| spread(cell, (COLUMNS, ROWS), at));
    DirectionTable::new(COLUMNS, &cells.collect::<Vec<f32>>(), 0.0, EVEN)
}

impl EnvironmentImage {
    /// The table of the picture: exactly the means of what is interpolated, unless it is very large.
    pub(crate) fn directions(&self) -> Option<DirectionTable> {
        if self.intensity == 0.0 {
            return None;
        }
        let (width, height) = (self.film.width() as usize, self.film.height() as usize);
        let turned = f64::from(self.rotation) / 360.0;
        let fits = 2 * width <= MOST_COLUMNS && 2 * height <= MOST_ROWS;
        // Even, so that no cell crosses the middle of a pixel, where what is interpolated has an edge.
        match (COLUMNS / width).min(ROWS / height) & !1 {
            0 if fits => DirectionTable::new(2 * width, &self.finely(2), turned, 0.0),
            0 => {
                let (columns, rows) = (width.min(MOST_COLUMNS), height.min(MOST_ROWS));
                let even = if (columns, rows) == (width, height) { 0.0 } else { EVEN };
                DirectionTable::new(columns, &self.coarsely(columns, rows), turned, even)
            }
            parts => DirectionTable::new(parts * width, &self.finely(parts), turned, 0.0),
        }
    }

    /// Pixels cut into so many parts along either side: within one, what is interpolated is on the mean what it is in the middle.
    fn finely(&self, parts: usize) -> Vec<f32> {
        let columns = self.film.width() as usize * parts;
        let rows = self.film.height() as usize * parts;
        let place = |at: usize| (at as f32 + 0.5) / parts as f32;
        (0..columns * rows)
            .map(|at| luminance(self.between(place(at % columns), place(at / columns))))
            .collect()
    }

    /// The means of as many pixels as fall into each cell.
    fn coarsely(&self, columns: usize, rows: usize) -> Vec<f32> {
        let (width, height) = (self.film.width() as usize, self.film.height() as usize);
        let at = |column: usize, row: usize| luminance(self.film.pixel(column as u32, row as u32));
        let mut cells = vec![(0.0_f32, 0.0_f32); columns * rows];
        for number in 0..width * height {
            let (column, row) = (number % width * columns / width, number / width * rows / height);
            let (sum, count) = &mut cells[row * columns + column];
            *sum += spread(number, (width, height), at);
            *count += 1.0;
        }
        cells.into_iter().map(|(sum, count)| sum / count).collect()
    }
}

/// How bright a colour is; what is no light is dark, and no sum of it infinite.
fn luminance([r, g, b, _]: [f32; 4]) -> f32 {
    let light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    // Of colours that are red alone, say, the blue is drawn as well: a channel counts that outshines the others.
    let light = light.max(r.max(g).max(b) * 0.1);
    if light > 0.0 { light.min(1e30) } else { 0.0 }
}

/// The mean over a cell of what is interpolated between the middles of the cells, those at the poles going on.
fn spread(cell: usize, (columns, rows): (usize, usize), at: impl Fn(usize, usize) -> f32) -> f32 {
    let (column, row) = (cell % columns, cell / columns);
    let across = [(column + columns - 1) % columns, column, (column + 1) % columns];
    let down = [row.saturating_sub(1), row, (row + 1).min(rows - 1)];
    let weights = [0.125, 0.75, 0.125];
    let mut sum = 0.0;
    for (row, down) in down.into_iter().zip(weights) {
        for (column, across) in across.into_iter().zip(weights) {
            sum += at(column, row) * across * down;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::film::Film;
    use crate::lights::Environment;
    use crate::sampling::light_position;

    fn image(width: u32, height: u32, color: impl Fn(u32, u32) -> f32) -> EnvironmentImage {
        let mut film = Film::new(width, height).unwrap();
        for row in 0..height {
            for column in 0..width {
                let light = color(column, row);
                film.set(column, row, [light, light * 0.5, 0.0, 1.0]);
            }
        }
        EnvironmentImage { film, intensity: 2.0, rotation: 37.0 }
    }

    /// The light from above on a floor, by samples, and by all directions in turn.
    fn irradiance(image: &EnvironmentImage) -> [f64; 2] {
        let table = image.directions().unwrap();
        let light = |direction: DVec3| {
            let color = image.color(direction.to_array().map(|x| x as f32));
            f64::from(color[0]) * direction.y.max(0.0)
        };
        let sum: f64 = (0..16_384)
            .filter_map(|sample| table.sample(light_position(1, 0, sample)))
            .map(|(direction, density)| light(direction) / f64::from(density))
            .sum();
        let even = DirectionTable::new(1, &[1.0], 0.0, 0.0).unwrap();
        let all: f64 = (0..1 << 18)
            .filter_map(|sample| even.sample(light_position(2, 0, sample)))
            .map(|(direction, density)| light(direction) / f64::from(density))
            .sum();
        [sum / 16_384.0, all / f64::from(1 << 18)]
    }

    #[test]
    fn samples_of_a_picture_find_all_of_its_light() {
        let striped =
            |column: u32, row: u32| if row.is_multiple_of(3) { (column % 4) as f32 } else { 0.0 };
        let sun = |column: u32, row: u32| match (column, row) {
            (20, 9) => 1e5,
            (_, row) if row < 16 => 0.5,
            _ => 0.0,
        };
        for image in [image(8, 6, striped), image(64, 32, sun), image(1, 1, |_, _| 3.0)] {
            let [sampled, all] = irradiance(&image);
            assert!((sampled / all - 1.0).abs() < 0.02, "{sampled} {all}");
        }
        assert!(image(4, 4, |_, _| 0.0).directions().is_none());
    }

    #[test]
    fn a_picture_that_is_too_large_is_looked_at_coarsely() {
        let wide =
            image(5000, 2, |column, row| if row == 0 { (column / 2500) as f32 } else { 0.0 });
        let [sampled, all] = irradiance(&wide);
        assert!((sampled / all - 1.0).abs() < 0.02, "{sampled} {all}");
    }

    #[test]
    fn the_table_of_a_sky_is_as_bright_as_the_sky() {
        let (zenith, horizon) = ([0.0, 0.0, 4.0], [0.5; 3]);
        let sky = Environment::Gradient { zenith, horizon, ground: [0.0; 3] };
        let colors: Vec<[f32; 4]> = looks().filter_map(|look| sky.color(look)).collect();
        let table = seen(&colors).unwrap();
        for at in 0..200 {
            let (direction, density) = table.sample(light_position(1, 0, at)).unwrap();
            let bright = |direction: DVec3| {
                luminance(sky.color(direction.to_array().map(|x| x as f32)).unwrap())
            };
            // What the two percents add is small where it is bright.
            if bright(direction) > 0.3 {
                let ratio = f64::from(bright(direction) / density)
                    / f64::from(bright(DVec3::Y) / table.density(DVec3::Y));
                assert!((ratio - 1.0).abs() < 0.1, "{direction} {ratio}");
            }
        }
    }
}
