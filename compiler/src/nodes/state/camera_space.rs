use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition::of_fields(
        "camera_space",
        "The transforms between the space of the camera and that of the scene, and how much it sees.",
        [
            ("to_world", Field::CameraToWorld),
            ("from_world", Field::WorldToCamera),
            ("height", Field::CameraHeight),
        ],
    )
}
