//! Directions drawn as densely as an environment is bright there.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

/// A table over all directions by longitude and latitude, laid out as a picture of an environment: directions are drawn from
/// a cell with the share of its light, and evenly over the solid angle within it (Pharr, Jakob and Humphreys, Physically
/// Based Rendering, 2-D piecewise-constant distributions). Being even by solid angle it has no poles to mind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DirectionTable {
    columns: usize,
    /// Turns by which the table is turned about y.
    turned: f64,
    /// Cosines from up at which rows begin and, last, where they end.
    cosines: Vec<f64>,
    /// Density of each cell per steradian, row by row.
    densities: Vec<f32>,
    /// Up to which of 0..1 numbers lead to a row and those above it.
    rows: Vec<f64>,
    /// Of each row, up to which of 0..1 numbers lead to a cell and those left of it.
    cells: Vec<f64>,
}

impl DirectionTable {
    /// Of the mean brightness of each cell, row by row from the top; what is no brightness counts for nothing. A share
    /// `even` of all directions is drawn evenly, whatever is there. None where there is no light at all.
    pub fn new(columns: usize, brightness: &[f32], turned: f64, even: f64) -> Option<Self> {
        let height = brightness.len() / columns.max(1);
        let edge = |row: usize| (PI * row as f64 / height as f64).cos();
        let cosines: Vec<f64> = (0..=height).map(edge).collect();
        let solid = |row: usize| (cosines[row] - cosines[row + 1]) * TAU / columns as f64;
        let light = |value: f32| if value.is_finite() { f64::from(value.max(0.0)) } else { 0.0 };
        let rows = || brightness.chunks_exact(columns.max(1)).enumerate();
        let total: f64 = rows()
            .map(|(row, cells)| cells.iter().map(|&cell| light(cell)).sum::<f64>() * solid(row))
            .sum();
        if total <= 0.0 {
            return None;
        }
        let density = |cell: f32| light(cell) / total * (1.0 - even) + even / (2.0 * TAU);
        let mut table = Self { columns, turned, densities: Vec::new(), ..Self::default() };
        let mut above = 0.0;
        for (row, cells) in rows() {
            let all: f64 = cells.iter().map(|&cell| density(cell)).sum();
            let mut left = 0.0;
            for &cell in cells {
                left += density(cell);
                table.cells.push(if all > 0.0 { left / all } else { 0.0 });
                table.densities.push(density(cell) as f32);
            }
            above += all * solid(row);
            table.rows.push(above);
        }
        table.rows.iter_mut().for_each(|row| *row /= above);
        table.cosines = cosines;
        Some(table)
    }

    /// The direction at a place of the unit square, and its density per steradian. None where rounding leads beside all light.
    pub fn sample(&self, [first, second]: [f64; 2]) -> Option<(DVec3, f32)> {
        let (row, down) = drawn(&self.rows, second);
        let (column, right) = drawn(self.row(&self.cells, row), first);
        let density = self.row(&self.densities, row)[column];
        if density == 0.0 {
            return None;
        }
        let cosine = self.cosines[row] + (self.cosines[row + 1] - self.cosines[row]) * down;
        let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
        let turns = (column as f64 + right) / self.columns as f64 + self.turned - 0.5;
        let (across, ahead) = (turns * TAU).sin_cos();
        Some((DVec3::new(sine * across, cosine, -sine * ahead), density))
    }

    /// How densely a unit direction is drawn, per steradian.
    pub fn density(&self, direction: DVec3) -> f32 {
        let turns = direction.x.atan2(-direction.z) / TAU + 0.5 - self.turned;
        let column = (turns - turns.floor()) * self.columns as f64;
        let height = self.rows.len();
        let row = direction.y.clamp(-1.0, 1.0).acos() / PI * height as f64;
        let row = (row as usize).min(height - 1);
        self.row(&self.densities, row)[(column as usize).min(self.columns - 1)]
    }

    fn row<'t, T>(&self, of: &'t [T], row: usize) -> &'t [T] {
        &of[row * self.columns..][..self.columns]
    }
}

/// The step of growing numbers up to 1 that a number leads to, and how far along it.
fn drawn(ends: &[f64], number: f64) -> (usize, f64) {
    let at = ends.partition_point(|end| *end <= number).min(ends.len() - 1);
    let start = if at == 0 { 0.0 } else { ends[at - 1] };
    let along = (number - start) / (ends[at] - start);
    (at, if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.5 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::light_position;

    /// Means over samples of what is seen over its density: the integral over all directions.
    fn integral(table: &DirectionTable, seen: impl Fn(DVec3) -> f64) -> f64 {
        let sum: f64 = (0..4096)
            .filter_map(|sample| table.sample(light_position(3, 0, sample)))
            .map(|(direction, density)| {
                assert!((direction.length() - 1.0).abs() < 1e-12 && density > 0.0);
                assert_eq!(table.density(direction), density, "{direction}");
                seen(direction) / f64::from(density)
            })
            .sum();
        sum / 4096.0
    }

    #[test]
    fn an_even_sky_is_drawn_evenly() {
        let table = DirectionTable::new(8, &[0.5; 32], 0.1, 0.0).unwrap();
        for at in 0..50 {
            let (direction, density) = table.sample(light_position(1, 0, at)).unwrap();
            assert!((f64::from(density) * 2.0 * TAU - 1.0).abs() < 1e-6);
            assert!((f64::from(table.density(direction)) * 2.0 * TAU - 1.0).abs() < 1e-6);
        }
        assert!((integral(&table, |direction| direction.y.max(0.0)) - PI).abs() < 0.01);
        for pole in [DVec3::Y, DVec3::NEG_Y] {
            assert!(table.density(pole) > 0.0);
        }
    }

    #[test]
    fn a_tiny_sun_takes_its_share_and_the_dark_is_never_drawn() {
        let mut brightness = [0.0; 64 * 32];
        brightness[10 * 64 + 5] = 1e5;
        let sun = DirectionTable::new(64, &brightness, 0.0, 0.0).unwrap();
        let (towards, density) = sun.sample([0.5; 2]).unwrap();
        for at in 0..50 {
            let (direction, _) = sun.sample(light_position(1, 0, at)).unwrap();
            assert!(direction.dot(towards) > 0.99);
        }
        assert_eq!(sun.density(-towards), 0.0);
        // Under a sky of 1 the sun, brighter 1e5 times in one cell, is drawn as often as its share of all light.
        let sky = brightness.map(|cell| cell + 1.0);
        let both = DirectionTable::new(64, &sky, 0.0, 0.0).unwrap();
        let drawn = (0..4096).filter_map(|sample| both.sample(light_position(3, 0, sample)));
        let in_sun = drawn.filter(|(_, density)| *density > 1.0).count() as f64 / 4096.0;
        let light = 1e5 / f64::from(density);
        assert!((in_sun - light / (light + 2.0 * TAU)).abs() < 2e-3, "{in_sun}");
        assert!(both.density(towards) < density && both.density(-towards) > 0.0);
        // A share is drawn anywhere.
        let shared = DirectionTable::new(64, &brightness, 0.0, 0.1).unwrap();
        let expected = 0.1 / (2.0 * TAU);
        assert!((f64::from(shared.density(-towards)) - expected).abs() < 1e-7);
    }

    #[test]
    fn poles_and_what_is_no_light() {
        let mut brightness = [f32::NAN; 8 * 4];
        assert_eq!(DirectionTable::new(8, &brightness, 0.0, 0.0), None);
        assert_eq!(DirectionTable::new(8, &[0.0; 32], 0.0, 0.5), None);
        assert_eq!(DirectionTable::new(8, &[], 0.0, 0.5), None);
        brightness[1] = f32::INFINITY;
        brightness[3] = 2.0;
        brightness[9] = -4.0;
        let table = DirectionTable::new(8, &brightness, 0.0, 0.0).unwrap();
        for at in [[0.0; 2], [1.0 - 1e-12; 2], [0.0, 1.0 - 1e-12]] {
            let (direction, density) = table.sample(at).unwrap();
            assert!(direction.is_finite() && density.is_finite());
            assert!(direction.y >= (PI / 4.0).cos() - 1e-12, "the first row");
        }
    }

    #[test]
    fn a_turn_moves_directions_and_densities_alike() {
        let mut brightness = [0.0; 64 * 32];
        brightness[15 * 64 + 32] = 1.0;
        for (turned, expected) in [(0.0, DVec3::NEG_Z), (0.25, DVec3::X), (-7.75, DVec3::X)] {
            let table = DirectionTable::new(64, &brightness, turned, 0.0).unwrap();
            let (direction, density) = table.sample([0.5; 2]).unwrap();
            assert!(direction.dot(expected) > 0.99, "{turned} {direction}");
            assert_eq!(table.density(direction), density);
        }
    }
}
