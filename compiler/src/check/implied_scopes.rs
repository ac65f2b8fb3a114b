//! Inputs that follow from what another input of their node is given: its value, or its slope, in a scope. The
//! nodes that say so are added here, so that engines know nothing of it.

use crate::graph::{Binding, Node};
use crate::nodes::{Definition, Implied, Input, NodeLibrary, Signature};
use crate::values::Literal;

use super::node_types::NodeTypes;

/// Adds the nodes that inputs imply, after all others. What is the same everywhere implies none, and what is never
/// looked at neither.
pub(super) fn add(node_types: &NodeTypes<'_>, nodes: &mut Vec<Node>) {
    let library = node_types.library;
    for at in 0..nodes.len() {
        let definition = node_types.definition(nodes[at].node_type);
        for (input, declared) in definition.signature.inputs.iter().enumerate() {
            let Some(implied) = declared.implied else { continue };
            let Some(of) = definition.signature.input(implied.of) else { continue };
            let source = match (&nodes[at].inputs[input], &nodes[at].inputs[of]) {
                (Binding::Default, Binding::Default) => continue,
                (Binding::Default, given) => given.clone(),
                _ => continue,
            };
            if never(definition, &nodes[at], input) {
                continue;
            }
            let implied = match source {
                Binding::Node { .. } => {
                    Implying { library, signature: &definition.signature, at, input: declared }
                        .nodes(implied, source, nodes)
                }
                // The same everywhere.
                _ if implied.slope => Some(Binding::Literal(Literal::Scalar(0.0))),
                same => Some(same),
            };
            if let Some(implied) = implied {
                nodes[at].inputs[input] = implied;
            }
        }
    }
}

/// Whether an input is never demanded, as far as what is known before shading tells.
fn never(definition: &Definition, node: &Node, input: usize) -> bool {
    let overload = &definition.overloads[node.overload];
    let Some(guard) = overload.guards[input] else { return false };
    let inputs = definition.signature.inputs.iter();
    let count: usize = inputs.map(|input| overload.width(input.value_type)).sum();
    let mut words = vec![0; count];
    let mut fixed = Vec::new();
    for (input, word) in definition.fixed_words(overload) {
        match &node.inputs[input] {
            Binding::Literal(Literal::Integer(number)) => fixed.push((word, *number)),
            Binding::Default => match definition.signature.inputs[input].default_number() {
                Some(number) => fixed.push((word, number)),
                None => return false,
            },
            _ => return false,
        }
    }
    for &(word, number) in &fixed {
        words[word] = number as u32;
    }
    let guard = guard.with_fixed(&fixed);
    if guard.recorded().reads(count).iter().any(|read| *read) {
        return false;
    }
    let mut holds = [0];
    guard.scalar(&words, &mut holds);
    holds[0] == 0
}

/// An input of a node for which nodes are added.
struct Implying<'l> {
    library: &'l NodeLibrary,
    signature: &'l Signature,
    /// Position of the node.
    at: usize,
    input: &'l Input,
}

impl Implying<'_> {
    /// Adds the nodes from a source on; none where the library lacks their types.
    fn nodes(&self, implied: Implied, source: Binding, nodes: &mut Vec<Node>) -> Option<Binding> {
        let of = &nodes[self.at];
        let shared = |name: &str| match self.shared(name) {
            Some(input) => of.inputs[input].clone(),
            None => Binding::Default,
        };
        let name = format!("{}[{}]", of.name, self.input.name);
        let scope = self.node(implied.scope, name.clone(), |input| match input.scoped {
            true => source.clone(),
            false => shared(&input.name),
        })?;
        let step = shared("step");
        nodes.push(scope);
        let there = Binding::Node { node: nodes.len() - 1, output: 0 };
        if !implied.slope {
            return Some(there);
        }
        let slope = self.node("slope", format!("{name}'"), |input| match &*input.name {
            "here" => source.clone(),
            "there" => there.clone(),
            "step" => step.clone(),
            _ => Binding::Default,
        })?;
        nodes.push(slope);
        Some(Binding::Node { node: nodes.len() - 1, output: 0 })
    }

    /// The input that a scope shares with the node. What the scope moves, and what it is looked at for, is its own.
    fn shared(&self, name: &str) -> Option<usize> {
        let input = self.signature.input(name)?;
        let moved = |input: &Input| input.implied.is_some_and(|implied| implied.of == name);
        let own = self.signature.inputs[input].implied.is_some()
            || self.signature.inputs.iter().any(moved);
        (!own).then_some(input)
    }

    fn node(
        &self,
        node_type: &str,
        name: String,
        input: impl Fn(&Input) -> Binding,
    ) -> Option<Node> {
        let node_type = self.library.find(node_type)?;
        let definition = self.library.definition(node_type);
        let mut forms = definition.overloads.iter();
        let overload =
            forms.position(|form| form.generic.is_none_or(|it| it == self.input.value_type))?;
        let inputs = definition.signature.inputs.iter().map(input).collect();
        Some(Node { name, node_type, overload, inputs })
    }
}
