//! Which state fields a node reads, itself or through its inputs: the static rule by which a scope
//! evaluates a node anew, written down a second time.

use std::collections::BTreeSet;

use crate::graph::{Binding, Node};
use crate::nodes::{DefaultValue, Kind, NodeLibrary};
use crate::state::{Field, Iterated};

/// Fields.
pub type Fields = BTreeSet<Field>;

/// The fields that a turn of a loop provides.
pub fn provided(by: Iterated) -> Fields {
    Field::ALL.iter().copied().filter(|field| field.of_loop() == Some(by)).collect()
}

/// The fields that differ inside what a node of this kind opens.
pub fn changed(kind: &Kind) -> Fields {
    match kind {
        Kind::Scope(fields) => fields.iter().copied().collect(),
        Kind::Loop(iterated, _) => provided(*iterated),
        Kind::Plain | Kind::Fields(_) | Kind::Request(_) | Kind::List(_) => Fields::new(),
    }
}

/// The node an input implies by its default.
pub fn implied(library: &NodeLibrary, name: &str) -> Node {
    let node_type = library.find(name).expect("implied nodes are in the library");
    let inputs = vec![Binding::Default; library.signature(node_type).inputs.len()];
    Node { name: format!("({name})"), node_type, overload: 0, inputs }
}

/// What `node` reads, given what an output of another node reads.
pub fn of_node(
    library: &NodeLibrary,
    node: &Node,
    of_output: &dyn Fn(usize, usize) -> Fields,
) -> Fields {
    let signature = library.signature(node.node_type);
    let mut fields: Fields = match &signature.kind {
        Kind::Request(effect) => effect.reads().iter().copied().collect(),
        Kind::Loop(Iterated::Lights, _) => [Field::Point, Field::NormalGeom].into(),
        Kind::Loop(Iterated::Samples, _)
        | Kind::Plain
        | Kind::Fields(_)
        | Kind::Scope(_)
        | Kind::List(_) => Fields::new(),
    };
    let changed = changed(&signature.kind);
    for (input, binding) in signature.inputs.iter().zip(&node.inputs) {
        let below = match (binding, &input.default) {
            (Binding::Node { node, output }, _) => of_output(*node, *output),
            (Binding::Default, DefaultValue::State(field)) => [*field].into(),
            (Binding::Default, DefaultValue::Node(name)) => of_implied(library, name, of_output),
            _ => Fields::new(),
        };
        fields.extend(below.into_iter().filter(|field| !input.scoped || !changed.contains(field)));
    }
    fields
}

fn of_implied(
    library: &NodeLibrary,
    name: &str,
    of_output: &dyn Fn(usize, usize) -> Fields,
) -> Fields {
    let node = implied(library, name);
    match &library.signature(node.node_type).kind {
        Kind::Fields(fields) => [fields[0]].into(),
        _ => of_node(library, &node, of_output),
    }
}

/// What an output of a node reads, given what the node as a whole reads.
pub fn of_output(library: &NodeLibrary, node: &Node, output: usize, whole: &Fields) -> Fields {
    match &library.signature(node.node_type).kind {
        Kind::Fields(fields) => [fields[output]].into(),
        _ => whole.clone(),
    }
}
