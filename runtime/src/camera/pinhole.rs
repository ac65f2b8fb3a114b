//! The pinhole camera.

use glam::{DMat3, DVec3};
use phenomenon_compiler::state;

use crate::geometry::{COORDINATE_LIMIT, Transform, double};

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: DVec3,
    /// To the middle of the picture, its length 1.
    forward: DVec3,
    /// To the right, half the picture's height at distance 1 long.
    right: DVec3,
    /// Up, as long as `right`.
    up: DVec3,
}

/// Why a camera cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A number is not finite or too large.
    #[error("the camera's numbers must be finite and at most 1e12 in magnitude")]
    NotFinite,
    /// Position and target coincide.
    #[error("the camera looks at its own position")]
    NoDirection,
    /// The up vector gives no direction.
    #[error("the camera's up vector is zero or points along its view")]
    NoUp,
    /// The field of view is out of range.
    #[error(
        "the vertical field of view is {0} degrees; it must lie between 0 and 180, both excluded"
    )]
    FieldOfView(f64),
}

impl Camera {
    /// A camera at `position` that looks at `look_at`, with a vertical field of view in degrees.
    pub fn new(
        position: [f64; 3],
        look_at: [f64; 3],
        up: [f64; 3],
        field_of_view: f64,
    ) -> Result<Self, CameraError> {
        let outside = |x: &f64| x.is_nan() || x.abs() > f64::from(COORDINATE_LIMIT);
        if position.iter().chain(&look_at).chain(&up).any(outside) {
            return Err(CameraError::NotFinite);
        }
        if !(field_of_view > 0.0 && field_of_view < 180.0) {
            return Err(CameraError::FieldOfView(field_of_view));
        }
        let position = DVec3::from(position);
        let forward =
            (DVec3::from(look_at) - position).try_normalize().ok_or(CameraError::NoDirection)?;
        let up = DVec3::from(up).try_normalize().ok_or(CameraError::NoUp)?;
        let right = forward.cross(up);
        if right.length() < 1e-9 {
            return Err(CameraError::NoUp);
        }
        let half_height = (field_of_view.to_radians() / 2.0).tan();
        let right = right.normalize();
        let up = right.cross(forward) * half_height;
        Ok(Self { position, forward, right: right * half_height, up })
    }

    /// What shaders can know of it.
    pub fn known(&self) -> state::Camera {
        let height = self.right.length();
        let axes = DMat3::from_cols(self.right / height, self.up / height, -self.forward);
        let to_world = Transform { linear: axes, translation: self.position };
        let to_camera = to_world.inverse();
        state::Camera {
            to_world: to_world.rows(),
            to_camera: to_camera.rows(),
            height: height as f32,
        }
    }

    /// By how much the cone of a pixel widens along a ray of a unit direction, on a film of so many rows: it is as
    /// wide as the pixel is high, in planes across the view.
    pub fn spread(&self, direction: [f32; 3], height: u32) -> f32 {
        let pixel = self.up.length() * 2.0 / f64::from(height);
        (pixel * double(direction).dot(self.forward)) as f32
    }

    /// Origin and unit direction of the ray through a point of the film, in pixels from the top
    /// left of a film of `width` by `height` pixels.
    pub fn ray(&self, film: [f32; 2], width: u32, height: u32) -> ([f32; 3], [f32; 3]) {
        let (width, height) = (f64::from(width), f64::from(height));
        let x = (2.0 * f64::from(film[0]) - width) / height;
        let y = (height - 2.0 * f64::from(film[1])) / height;
        let direction = (self.forward + self.right * x + self.up * y).normalize();
        let single = |v: DVec3| [v.x as f32, v.y as f32, v.z as f32];
        (single(self.position), single(direction))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_stands_upright_and_spans_the_field_of_view() {
        let camera = Camera::new([0.0; 3], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0], 90.0).unwrap();
        let half = std::f32::consts::FRAC_1_SQRT_2;
        assert_eq!(camera.ray([2.0, 1.0], 4, 2).1, [0.0, 0.0, -1.0]);
        let top = camera.ray([2.0, 0.0], 4, 2).1;
        assert!((top[1] - half).abs() < 1e-6 && (top[2] + half).abs() < 1e-6, "{top:?}");
        let right = camera.ray([4.0, 1.0], 4, 2).1;
        assert!(right[0] > 0.8 && right[1] == 0.0);
    }

    #[test]
    fn its_space_has_x_to_the_right_y_up_and_z_towards_the_viewer() {
        let camera = Camera::new([1.0, 2.0, 3.0], [5.0, 2.0, 3.0], [0.0, 7.0, 0.0], 90.0).unwrap();
        let known = camera.known();
        let rows = [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0, 0.0],
            [1.0, 2.0, 3.0, 1.0],
        ];
        assert_eq!(known.to_world, rows.as_flattened());
        assert!((known.height - 1.0).abs() < 1e-7);
        assert_eq!(known.to_camera[12..], [-3.0, -2.0, 1.0, 1.0]);
    }

    #[test]
    fn impossible_cameras_are_refused() {
        let make = |look_at, up, fov| Camera::new([0.0; 3], look_at, up, fov);
        let (ahead, up) = ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
        assert_eq!(make([0.0; 3], up, 40.0), Err(CameraError::NoDirection));
        assert_eq!(make(ahead, ahead, 40.0), Err(CameraError::NoUp));
        assert_eq!(make(ahead, [0.0; 3], 40.0), Err(CameraError::NoUp));
        assert_eq!(make(ahead, up, 180.0), Err(CameraError::FieldOfView(180.0)));
        assert!(matches!(make(ahead, up, f64::NAN), Err(CameraError::FieldOfView(_))));
        assert_eq!(make([f64::INFINITY, 0.0, 0.0], up, 40.0), Err(CameraError::NotFinite));
    }
}
