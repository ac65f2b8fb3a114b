use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let fields = Field::ALL.iter().copied().filter(|field| field.of_point());
    Definition::of_fields(
        "state",
        "The fields of the state, one output each.",
        fields.map(|field| (field.name(), field)),
    )
}
