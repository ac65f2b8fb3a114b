//! Types of generic nodes, resolved from what is connected to them.

use std::collections::HashMap;

use crate::document::numbers::{self, Whole};
use crate::document::{Value, ValueKind};
use crate::nodes::{Definition, NodeType};
use crate::values::Type;

use super::draft::{Draft, DraftNode, Source, SourceKind};
use super::literals::natural_type;

/// For each node, what [`Type::Generic`] stands for; none where that is not known, and for nodes
/// without generic inputs.
pub(super) struct Types {
    generic: Vec<Option<Type>>,
    /// Types of expressions, by where they start, while they are written out.
    pub expressions: HashMap<usize, Option<Type>>,
}

impl Types {
    /// Nothing is known yet.
    pub fn unknown(draft: &Draft<'_>) -> Self {
        Self { generic: vec![None; draft.nodes.len()], expressions: HashMap::new() }
    }

    /// Resolves a node, all it reads being known.
    pub fn settle(&mut self, draft: &Draft<'_>, node: usize) {
        let drafted = &draft.nodes[node];
        if let Some(node_type) = drafted.node_type
            && draft.node_types.signature(node_type).is_generic()
        {
            self.generic[node] = resolve_node(draft, self, drafted, node_type);
        }
    }

    /// What the generic inputs of a node are.
    pub fn generic(&self, node: usize) -> Option<Type> {
        self.generic[node]
    }

    /// The type of a source that is not a literal; none where it is not known. Components are scalars.
    pub fn of(&self, draft: &Draft<'_>, source: &Source<'_>) -> Option<Type> {
        match source.component {
            Some(_) => Some(Type::Scalar),
            None => self.of_whole(draft, source),
        }
    }

    /// The type of that of which a source may be a component.
    pub fn of_whole(&self, draft: &Draft<'_>, source: &Source<'_>) -> Option<Type> {
        match source.kind {
            SourceKind::Parameter(parameter) => draft.parameters[parameter].value_type,
            SourceKind::Node(node, Some(output)) => {
                let node_type = draft.nodes[node].node_type?;
                match draft.node_types.signature(node_type).outputs[output].value_type {
                    Type::Generic => self.generic[node],
                    known => Some(known),
                }
            }
            SourceKind::Broken => self.expressions.get(&source.value.start).copied().flatten(),
            SourceKind::Node(_, None) | SourceKind::Literal | SourceKind::Compound(_) => None,
        }
    }
}

/// Resolves every generic node. `order` has sources before what reads them, except in cycles.
pub(super) fn resolve(draft: &Draft<'_>, order: &[usize]) -> Types {
    let mut types = Types::unknown(draft);
    order.iter().for_each(|&node| types.settle(draft, node));
    types
}

/// The widest type that arrives at generic inputs, as an overload has it.
fn resolve_node(
    draft: &Draft<'_>,
    types: &Types,
    node: &DraftNode<'_>,
    node_type: NodeType,
) -> Option<Type> {
    let signature = draft.node_types.signature(node_type);
    let takes = |of: Type| signature.generic.contains(&of);
    let mut widest: Option<Type> = None;
    let mut vector = false;
    let mut triple = false;
    let mut other: Option<Type> = None;
    let mut unknown = false;
    for input in &node.inputs {
        let generic =
            input.input.is_some_and(|at| signature.inputs[at].value_type == Type::Generic);
        if !generic {
            continue;
        }
        let arriving = match input.source.kind {
            SourceKind::Literal => {
                // Three numbers are a color, or a vector where another input is one.
                let list = natural_type(input.source.value) == Some(Type::Color);
                if list && is_triple(&input.source) {
                    triple = true;
                    continue;
                }
                // A whole number is an integer where others are.
                if takes(Type::Integer) && is_whole(input.source.value) {
                    continue;
                }
                // What is no number is reported as such, whatever the others are.
                let Some(natural) = literal_type(input.source.value, &signature.generic) else {
                    continue;
                };
                Some(natural)
            }
            _ => types.of(draft, &input.source),
        };
        match arriving {
            Some(Type::Vector) => vector = true,
            Some(found) if !found.is_numeric() => {
                other = other.or(Some(found).filter(|found| takes(*found)));
            }
            Some(found) => widest = Some(widest.map_or(found, |so_far| wider(so_far, found))),
            None => unknown = true,
        }
    }
    let resolved = match (widest, vector, triple) {
        (None, false, false) if let Some(other) = other => other,
        (Some(Type::Color), _, _) => Type::Color,
        (_, true, _) => Type::Vector,
        (_, false, true) => Type::Color,
        // What is not known may be wider; to guess would only raise findings that follow from it.
        _ if unknown => return None,
        (Some(found), ..) => found,
        (None, ..) => Type::Scalar,
    };
    overload_type(draft.node_types.definition(node_type), resolved)
}

/// The type a literal has by itself at an input of one of these types.
pub(super) fn literal_type(value: &Value, types: &[Type]) -> Option<Type> {
    match &value.kind {
        ValueKind::Array(elements) if elements.len() == 16 && types.contains(&Type::Transform) => {
            Some(Type::Transform)
        }
        _ => natural_type(value),
    }
}

/// Whether a literal is a whole number that an integer keeps: -0 would lose its sign.
fn is_whole(value: &Value) -> bool {
    match &value.kind {
        ValueKind::Number(text) => match numbers::whole(text) {
            Whole::Number(0) => !text.starts_with('-'),
            Whole::Number(number) => i32::try_from(number).is_ok(),
            Whole::Fraction | Whole::NoNumber => false,
        },
        _ => false,
    }
}

fn is_triple(source: &Source<'_>) -> bool {
    matches!(&source.value.kind, ValueKind::Array(elements) if elements.len() == 3)
}

fn wider(a: Type, b: Type) -> Type {
    if a.converts_to(b) { b } else { a }
}

/// The type of the first overload that takes `wanted`; else of the first there is, so that the
/// mismatch is reported against something.
pub(super) fn overload_type(definition: &Definition, wanted: Type) -> Option<Type> {
    let overloads = &definition.overloads;
    let exact = overloads.iter().find(|overload| overload.generic == Some(wanted));
    let converting = overloads
        .iter()
        .find(|overload| overload.generic.is_some_and(|generic| wanted.converts_to(generic)));
    exact.or(converting).or(overloads.first()).and_then(|overload| overload.generic)
}

/// Position of the overload for a resolved type; 0 for nodes without generic inputs.
pub(super) fn overload(definition: &Definition, generic: Option<Type>) -> usize {
    let overloads = &definition.overloads;
    overloads.iter().position(|overload| overload.generic == generic).unwrap_or(0)
}
