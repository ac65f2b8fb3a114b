use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Real, Vector};
use crate::nodes::finite::FACTOR;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Where on the picture a point of the scene is seen: y from -1 at the lower edge to 1 at the upper, x
    /// in the same measure from the middle to the right, and as z how deep it lies, along the view. With
    /// (x, y, z) as the camera has it, `(x / (-z h), y / (-z h), -z)`, h half the height of what the camera
    /// sees at distance 1. In the plane of the camera x and y are 0; behind it the picture stands on its head
    /// and z is below 0.
    world_to_screen in spaces,
    source "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed., 5.1.1",
    inputs {
        /// The point, in the space of the scene.
        point: vector = state(Field::Point), in FACTOR;
        /// From the space of the scene to that of the camera.
        world_to_camera: transform = state(Field::WorldToCamera), in FACTOR;
        /// Half the height of what the camera sees at distance 1.
        height: scalar = state(Field::CameraHeight), in 0.0..=1e6;
    }
    outputs {
        /// Where it is seen, and how deep.
        result: vector;
    }
    body |e, i| {
        let seen = i.world_to_camera.point(i.point);
        let depth = -seen.z;
        let size = depth * i.height;
        Outputs {
            result: Vector {
                x: clamp_finite(seen.x.divide_or_zero(size)),
                y: clamp_finite(seen.y.divide_or_zero(size)),
                z: clamp_finite(depth),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_edges_of_the_picture_are_one_away() {
        // By default the camera is at the origin, and its edges are at right angles.
        let seen = |point: [f32; 3]| numbers!(point = point, height = 0.5 => result);
        assert_eq!(seen([0.0, 0.0, -3.0]), [0.0, 0.0, 3.0]);
        assert_eq!(seen([1.0, 2.0, -4.0]), [0.5, 1.0, 4.0]);
        assert_eq!(seen([1.0, 2.0, 4.0]), [-0.5, -1.0, -4.0]);
        assert_eq!(seen([1.0, 2.0, 0.0]), [0.0, 0.0, 0.0]);
        assert_eq!(numbers!(point = [1.0, 2.0, -4.0], height = 0.0 => result), [0.0, 0.0, 4.0]);
    }
}
