use crate::emit::Vector;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::finite::FACTOR;
use crate::nodes::{node, state};
use crate::state::Field;

node! {
    /// The point of the scene that is seen somewhere on the picture, at some depth: what `world_to_screen` makes of
    /// it leads back. `(x z h, y z h, -z)` as the camera has it, h half the height of what the camera sees at
    /// distance 1.
    screen_to_world in spaces,
    source "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed., 5.1.1",
    inputs {
        /// Where on the picture, and how deep: see `world_to_screen`.
        screen: vector = node("world_to_screen"), in FACTOR;
        /// From the space of the camera to that of the scene.
        camera_to_world: transform = state(Field::CameraToWorld), in FACTOR;
        /// Half the height of what the camera sees at distance 1.
        height: scalar = state(Field::CameraHeight), in 0.0..=1e6;
    }
    outputs {
        /// The point, in the space of the scene.
        point: vector;
    }
    body |e, i| {
        let size = i.screen.z * i.height;
        let seen = Vector { x: i.screen.x * size, y: i.screen.y * size, z: -i.screen.z };
        let Vector { x, y, z } = i.camera_to_world.point(seen);
        Outputs { point: Vector { x: clamp_finite(x), y: clamp_finite(y), z: clamp_finite(z) } }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_leads_back() {
        assert_eq!(numbers!(screen = [0.5, 1.0, 4.0], height = 0.5 => point), [1.0, 2.0, -4.0]);
        assert_eq!(numbers!(screen = [0.0, 0.0, 3.0], height = 0.5 => point), [0.0, 0.0, -3.0]);
    }
}
