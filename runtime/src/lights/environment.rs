//! What rays see that leave the scene.

use std::sync::Arc;

use phenomenon_compiler::engine::Shade;

use crate::film::Film;

/// What rays see that leave the scene.
#[derive(Clone)]
pub enum Environment {
    /// One colour all round.
    Constant([f32; 4]),
    /// A sky: `horizon` at height 0, blending to `zenith` straight up and `ground` straight down,
    /// linear in the height (y) of the direction.
    Gradient {
        /// Straight up.
        zenith: [f32; 3],
        /// At eye level.
        horizon: [f32; 3],
        /// Straight down.
        ground: [f32; 3],
    },
    /// A picture wrapped round.
    Image(Arc<EnvironmentImage>),
    /// A shader, called for its environment root.
    Shader(Arc<dyn Shade>),
}

impl Environment {
    /// The shader, if it is one.
    pub fn shader(&self) -> Option<&Arc<dyn Shade>> {
        match self {
            Environment::Shader(shader) => Some(shader),
            Environment::Constant(_) | Environment::Gradient { .. } | Environment::Image(_) => None,
        }
    }

    /// The colour seen in a unit direction; none if a shader must say.
    #[inline]
    pub fn color(&self, direction: [f32; 3]) -> Option<[f32; 4]> {
        match self {
            Environment::Constant(color) => Some(*color),
            Environment::Gradient { zenith, horizon, ground } => {
                let height = direction[1].clamp(-1.0, 1.0);
                let end = if height < 0.0 { ground } else { zenith };
                let weight = height.abs();
                let blend = |k: usize| horizon[k] + (end[k] - horizon[k]) * weight;
                Some([blend(0), blend(1), blend(2), 1.0])
            }
            Environment::Image(image) => Some(image.color(direction)),
            Environment::Shader(_) => None,
        }
    }
}

/// A latitude-longitude picture: its middle column faces -z, its top row is up.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvironmentImage {
    /// Scene-linear pixels.
    pub film: Film,
    /// Factor on its colours.
    pub intensity: f32,
    /// Degrees by which it is turned about y.
    pub rotation: f32,
}

impl EnvironmentImage {
    /// The colour in a unit direction, bilinear between pixels.
    pub fn color(&self, direction: [f32; 3]) -> [f32; 4] {
        use std::f32::consts::{PI, TAU};
        let [x, y, z] = direction;
        let turns = x.atan2(-z) / TAU + 0.5 - self.rotation / 360.0;
        let latitude = y.clamp(-1.0, 1.0).acos() / PI;
        let (width, height) = (self.film.width() as f32, self.film.height() as f32);
        let [r, g, b, _] = self.between((turns - turns.floor()) * width, latitude * height);
        let scale = self.intensity;
        [r * scale, g * scale, b * scale, 1.0]
    }

    /// The colour at a place in pixels from the upper left corner, bilinear between their middles, without the factor.
    pub(super) fn between(&self, column: f32, row: f32) -> [f32; 4] {
        let (width, height) = (self.film.width() as i64, self.film.height() as i64);
        let (column, row) = (column - 0.5, row - 0.5);
        let (left, top) = (column.floor(), row.floor());
        let (across, down) = (column - left, row - top);
        let at = |column: i64, row: i64| {
            let column = column.rem_euclid(width) as u32;
            self.film.pixel(column, row.clamp(0, height - 1) as u32)
        };
        let (left, top) = (left as i64, top as i64);
        let corners = [at(left, top), at(left + 1, top), at(left, top + 1), at(left + 1, top + 1)];
        let weights = [
            (1.0 - across) * (1.0 - down),
            across * (1.0 - down),
            (1.0 - across) * down,
            across * down,
        ];
        let blend = |k: usize| (0..4).map(|at| corners[at][k] * weights[at]).sum::<f32>();
        [blend(0), blend(1), blend(2), 1.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_blend_by_height() {
        let sky =
            Environment::Gradient { zenith: [0.0, 0.0, 1.0], horizon: [1.0; 3], ground: [0.5; 3] };
        assert_eq!(sky.color([0.0, 1.0, 0.0]), Some([0.0, 0.0, 1.0, 1.0]));
        assert_eq!(sky.color([1.0, 0.0, 0.0]), Some([1.0; 4]));
        assert_eq!(sky.color([0.0, -1.0, 0.0]), Some([0.5, 0.5, 0.5, 1.0]));
    }

    #[test]
    fn the_middle_of_an_image_faces_minus_z_and_its_seam_is_closed() {
        let mut film = Film::new(4, 2).unwrap();
        for row in 0..2 {
            for column in 0..4 {
                film.set(column, row, [column as f32, row as f32, 0.0, 1.0]);
            }
        }
        let image = EnvironmentImage { film, intensity: 1.0, rotation: 0.0 };
        assert_eq!(image.color([0.0, 0.0, -1.0])[0], 1.5);
        // +x lies a quarter turn to the right: between columns 2 and 3.
        assert!((image.color([1.0, 0.0, 0.0])[0] - 2.5).abs() < 1e-5);
        // +z is the seam: halfway between the last and the first column.
        assert!((image.color([0.0, 0.0, 1.0])[0] - 1.5).abs() < 1e-5);
        assert_eq!(image.color([0.0, 1.0, 0.0])[1], 0.0);
        assert_eq!(image.color([0.0, -1.0, 0.0])[1], 1.0);
    }
}
