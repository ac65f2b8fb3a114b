use crate::nodes::Definition;
use crate::state::{Field, Holder};

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    let of_point = |field: &Field| matches!(field.holder(), Holder::State | Holder::Surface);
    let fields = Field::ALL.iter().copied().filter(of_point);
    Definition::of_fields(
        "state",
        "The fields of the state, and what the surface is like there, one output each. What is not read is not \
         worked out.",
        fields.map(|field| (field.name(), field)),
    )
}
