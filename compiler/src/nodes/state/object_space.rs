use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition::of_fields(
        "object_space",
        "The transforms between the space of the object the point is on and that of the scene.",
        [("to_world", Field::ObjectToWorld), ("from_world", Field::WorldToObject)],
    )
}
