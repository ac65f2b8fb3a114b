//! Connections that are never evaluated, because literals decide their guard.

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, shortened};
use crate::graph::{Binding, Graph, Node};
use crate::nodes::{Default, Literal, NodeLibrary, Type};

use super::draft::{Draft, SourceKind};

/// The inputs of a checked graph that are never evaluated, whatever is given for them, because
/// constants decide their guard: positions of a node and of one of its inputs, ascending.
pub fn dead_inputs(graph: &Graph, library: &NodeLibrary) -> Vec<(usize, usize)> {
    let mut dead = Vec::new();
    for (at, node) in graph.nodes.iter().enumerate() {
        let inputs = library.signature(node.node_type).inputs.iter().enumerate();
        let ruled_out = inputs.filter(|(input, it)| it.guarded && never(library, node, *input));
        dead.extend(ruled_out.map(|(input, _)| (at, input)));
    }
    dead
}

/// Reports connections to inputs whose guard never holds. `nodes` are the bound nodes, one for each
/// of the draft.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>, nodes: &[Node]) {
    for (at, (drafted, node)) in draft.nodes.iter().zip(nodes).enumerate() {
        // In the place of a node over a list stand others, which have inputs of their own.
        if drafted.node_type != Some(node.node_type) {
            continue;
        }
        let signature = draft.library.signature(node.node_type);
        for given in &drafted.inputs {
            let Some(input) = given.input else { continue };
            let connected = matches!(given.source.kind, SourceKind::Node(..));
            if !connected || !signature.inputs[input].guarded || !never(&draft.library, node, input)
            {
                continue;
            }
            let deciding: Vec<String> = signature.inputs[..input]
                .iter()
                .filter(|earlier| !earlier.guarded)
                .map(|earlier| format!("`{}`", earlier.name))
                .collect();
            let name = shortened(draft.name(at));
            let input = signature.inputs[input].name;
            let message = format!(
                "input `{input}` of node `{name}` ({}) is never evaluated: the constant {} rules it out",
                signature.name,
                deciding.join(" and "),
            );
            let help = format!(
                "connect {} to something that varies, or remove `{input}`",
                deciding.join(" or ")
            );
            let place = reader.document.place(given.source.value);
            reader.findings.push(Finding::new(Code::DEAD_INPUT, place, message, help));
        }
    }
}

/// Whether the guard of an input fails for certain: all that it may look at is constant. A guard
/// looks at earlier inputs, and never at guarded ones, which would have to be evaluated for it.
fn never(library: &NodeLibrary, node: &Node, input: usize) -> bool {
    let definition = library.definition(node.node_type);
    let overload = &definition.overloads[node.overload];
    let Some(guard) = overload.guards.get(input).copied().flatten() else { return false };
    let mut words = Vec::new();
    for (at, declared) in definition.signature.inputs.iter().enumerate() {
        let of = match (declared.value_type, overload.generic) {
            (Type::Generic, Some(generic)) => generic,
            (other, _) => other,
        };
        let looked_at = at < input && !declared.guarded;
        let constant = match (&node.inputs[at], &declared.default) {
            (Binding::Literal(literal), _) | (Binding::Default, Default::Literal(literal)) => {
                spread(literal, of)
            }
            _ => None,
        };
        match constant {
            Some(constant) if looked_at => words.extend(constant),
            None if looked_at => return false,
            _ => words.extend(std::iter::repeat_n(0, of.width())),
        }
    }
    let mut holds = [0];
    (guard.scalar_portable)(&words, &mut holds);
    holds[0] == 0
}

/// A literal's words as an input of that type holds them; a number is repeated over components.
fn spread(literal: &Literal, to: Type) -> Option<Vec<u32>> {
    match (literal, to) {
        (Literal::Scalar(x), Type::Vector) => Some(vec![x.to_bits(); 3]),
        _ => literal.converted_to(to).map(|literal| literal.words()),
    }
}
