//! Which nodes read the light sample by themselves, and so stand below the body of a light loop.

use std::collections::HashSet;

use crate::state::Field;

use super::{DefaultValue, Kind, NodeLibrary, NodeType};

/// Whether an output of a node type is of the light sample by itself, whatever its inputs.
pub fn is_of_light(library: &NodeLibrary, node_type: NodeType, output: Option<usize>) -> bool {
    match &library.signature(node_type).kind {
        Kind::Fields(fields) => match output {
            Some(output) => fields.get(output).copied().is_some_and(Field::is_of_light),
            None => false,
        },
        Kind::Request(effect) => effect.reads().iter().any(|field| field.is_of_light()),
        Kind::Plain | Kind::Scope(_) | Kind::LightLoop | Kind::List(_) => false,
    }
}

/// Whether a default reads the light sample, through the implied nodes behind it.
fn default_reads_light(
    library: &NodeLibrary,
    default: &DefaultValue,
    seen: &mut HashSet<NodeType>,
) -> bool {
    match default {
        DefaultValue::State(field) => field.is_of_light(),
        DefaultValue::Node(name) => library
            .find(name)
            .is_some_and(|node_type| seen.insert(node_type) && implied(library, node_type, seen)),
        DefaultValue::Required | DefaultValue::Literal(_) => false,
    }
}

/// Whether a node whose inputs are all defaults reads the light sample in its first output.
fn implied(library: &NodeLibrary, node_type: NodeType, seen: &mut HashSet<NodeType>) -> bool {
    let signature = library.signature(node_type);
    is_of_light(library, node_type, Some(0))
        || signature.inputs.iter().any(|input| {
            let within = input.scoped && signature.kind == Kind::LightLoop;
            !within && default_reads_light(library, &input.default, seen)
        })
}

/// Whether the input of a node type, left to its default, reads the light sample and so may stand
/// only below the body of a light loop.
pub fn reads_light(library: &NodeLibrary, node_type: NodeType, input: usize) -> bool {
    let default = &library.signature(node_type).inputs[input].default;
    default_reads_light(library, default, &mut HashSet::new())
}
