//! Which nodes read what the turns of a loop provide, by themselves, and so stand below the body of such
//! a loop.

use std::collections::HashSet;

use crate::state::{Field, Iterated};

use super::{DefaultValue, Kind, NodeLibrary, NodeType};

/// Whether an output of a node type is of the turn of a loop by itself, whatever its inputs.
pub fn is_of_turn(
    library: &NodeLibrary,
    node_type: NodeType,
    output: Option<usize>,
    of: Iterated,
) -> bool {
    let is_provided = |field: &Field| field.of_loop() == Some(of);
    match &library.signature(node_type).kind {
        Kind::Fields(fields) => match output {
            Some(output) => fields.get(output).is_some_and(is_provided),
            None => false,
        },
        Kind::Request(effect) => effect.reads().iter().any(is_provided),
        Kind::Plain | Kind::Scope(_) | Kind::Loop(..) | Kind::List(_) => false,
    }
}

/// Whether a default reads the turn of a loop, through the implied nodes behind it.
fn default_reads_turn(
    library: &NodeLibrary,
    default: &DefaultValue,
    of: Iterated,
    seen: &mut HashSet<NodeType>,
) -> bool {
    match default {
        DefaultValue::State(field) => field.of_loop() == Some(of),
        DefaultValue::Node(name) => library.find(name).is_some_and(|node_type| {
            seen.insert(node_type) && implied(library, node_type, of, seen)
        }),
        DefaultValue::Required | DefaultValue::Literal(_) => false,
    }
}

/// Whether a node whose inputs are all defaults reads the turn of a loop in its first output.
fn implied(
    library: &NodeLibrary,
    node_type: NodeType,
    of: Iterated,
    seen: &mut HashSet<NodeType>,
) -> bool {
    let signature = library.signature(node_type);
    is_of_turn(library, node_type, Some(0), of)
        || signature.inputs.iter().any(|input| {
            let over = match signature.kind {
                Kind::Loop(iterated, _) => Some(iterated),
                _ => None,
            };
            let within = input.scoped && over == Some(of);
            !within && default_reads_turn(library, &input.default, of, seen)
        })
}

/// Whether the input of a node type, left to its default, reads the turn of a loop and so may stand
/// only below the body of one.
pub fn reads_turn(library: &NodeLibrary, node_type: NodeType, input: usize, of: Iterated) -> bool {
    let default = &library.signature(node_type).inputs[input].default;
    default_reads_turn(library, default, of, &mut HashSet::new())
}
