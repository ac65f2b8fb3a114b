//! Nodes over lists, as the nodes they stand for.

use crate::graph::{Binding, Node};
use crate::nodes::{NodeLibrary, NodeType};
use crate::values::{Literal, Type};

/// What a node over a list is given.
pub(super) struct Values {
    /// Which value, or where along a ramp; none for a sum.
    pub index: Binding,
    /// How a ramp goes from stop to stop.
    pub interpolation: Binding,
    /// Where the values of a ramp stand; else empty.
    pub positions: Vec<Binding>,
    /// At least one.
    pub values: Vec<Binding>,
    /// The type of all of them.
    pub generic: Type,
}

/// A node over a list.
pub(super) struct List<'l> {
    pub library: &'l NodeLibrary,
    pub name: &'l str,
    pub values: Values,
    /// Position in the graph of the first node that is added.
    pub next: usize,
}

impl List<'_> {
    /// From the last value to the first: whether the index is at most this one's, and if not the
    /// rest. The node that takes the place of this one, and those that are added; none where the library
    /// lacks their types.
    pub fn element(self) -> Option<(Node, Vec<Node>)> {
        let Values { index, mut values, .. } = self.values;
        let generic = self.values.generic;
        let mut added = Vec::new();
        let mut rest = values.pop()?;
        if values.is_empty() {
            return Some((select(self.library, self.name, generic, truth(), rest)?, added));
        }
        while let Some(value) = values.pop() {
            let at = values.len();
            let name = format!("{}[{at}]", self.name);
            let bound = Binding::Literal(Literal::Integer(i32::try_from(at).ok()?));
            let inputs = vec![("a", index.clone()), ("b", bound)];
            let of = Some(Type::Integer);
            added.push(node(self.library, "less_equal", format!("{name}?"), of, inputs)?);
            let holds = Binding::Node { node: self.next + added.len() - 1, output: 0 };
            let name = if at == 0 { self.name } else { &name };
            let mut chosen = select(self.library, name, generic, holds, value)?;
            let otherwise = input(self.library, chosen.node_type, "if_false")?;
            chosen.inputs[otherwise] = rest;
            if at == 0 {
                return Some((chosen, added));
            }
            added.push(chosen);
            rest = Binding::Node { node: self.next + added.len() - 1, output: 0 };
        }
        None
    }

    /// From the first value to the last.
    pub fn sum(self) -> Option<(Node, Vec<Node>)> {
        let Values { values, generic, .. } = self.values;
        let mut added: Vec<Node> = Vec::new();
        let mut values = values.into_iter();
        let mut sum = values.next()?;
        let count = values.len();
        if count == 0 {
            return Some((select(self.library, self.name, generic, truth(), sum)?, added));
        }
        for (at, value) in values.enumerate() {
            let last = at + 1 == count;
            let name = if last { self.name.to_owned() } else { format!("{}[{at}]", self.name) };
            let inputs = vec![("a", sum), ("b", value)];
            let adding = node(self.library, "add", name, Some(generic), inputs)?;
            if last {
                return Some((adding, added));
            }
            added.push(adding);
            sum = Binding::Node { node: self.next + added.len() - 1, output: 0 };
        }
        None
    }
}

pub(super) fn truth() -> Binding {
    Binding::Literal(Literal::Boolean(true))
}

pub(super) fn select(
    library: &NodeLibrary,
    name: &str,
    generic: Type,
    condition: Binding,
    if_true: Binding,
) -> Option<Node> {
    let inputs = vec![("condition", condition), ("if_true", if_true)];
    node(library, "select", name.to_owned(), Some(generic), inputs)
}

pub(super) fn node(
    library: &NodeLibrary,
    type_name: &str,
    name: String,
    generic: Option<Type>,
    given: Vec<(&str, Binding)>,
) -> Option<Node> {
    let node_type = library.find(type_name)?;
    let definition = library.definition(node_type);
    let overload = definition.overloads.iter().position(|form| form.generic == generic)?;
    let mut inputs = vec![Binding::Default; definition.signature.inputs.len()];
    for (of, binding) in given {
        inputs[input(library, node_type, of)?] = binding;
    }
    Some(Node { name, node_type, overload, inputs })
}

fn input(library: &NodeLibrary, node_type: NodeType, name: &str) -> Option<usize> {
    library.signature(node_type).input(name)
}
