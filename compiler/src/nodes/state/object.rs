use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition::of_fields(
        "object",
        "What is known of the object the point is on, the same all over it.",
        [("id", Field::ObjectId), ("random", Field::ObjectRandom)],
    )
}
