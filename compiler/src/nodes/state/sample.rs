use crate::nodes::Definition;
use crate::state::Field;

/// What the list of nodes holds of this node.
pub fn definition() -> Definition {
    Definition::of_fields(
        "sample",
        "The sample of the loop round this node: its number, and two numbers drawn for it, evenly spread over \
         the unit square. They are drawn anew for each point, sample and loop, the same in all engines; only \
         inside a sample loop. Nodes that draw a direction take the two numbers by default.",
        [("index", Field::SampleIndex), ("u", Field::SampleU), ("v", Field::SampleV)],
    )
}
