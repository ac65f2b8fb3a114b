//! What is known of the camera.

use super::object::IDENTITY;

/// Where the scene is seen from. In its space x is to the right, y up, and it looks along -z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// From its space to that of the scene.
    pub to_world: [f32; 16],
    /// From the space of the scene to its own.
    pub to_camera: [f32; 16],
    /// Half the height of what it sees at distance 1.
    pub height: f32,
}

impl Camera {
    /// A camera at the origin, looking along -z, whose upper and lower edges are at right angles.
    pub const AT_ORIGIN: Self = Self { to_world: IDENTITY, to_camera: IDENTITY, height: 1.0 };
}

impl Default for Camera {
    fn default() -> Self {
        Self::AT_ORIGIN
    }
}
