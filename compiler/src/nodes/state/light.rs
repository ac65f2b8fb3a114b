use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition::of_fields(
        "light",
        "Where the light sample of the loop round this node lies, and how densely such samples lie there; only inside a light loop.",
        [
            ("direction", Field::LightDirection),
            ("distance", Field::LightDistance),
            ("density", Field::LightDensity),
        ],
    )
}
