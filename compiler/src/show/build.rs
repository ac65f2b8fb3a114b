//! The diagram of a graph.

use crate::graph::{Binding, Graph, Output, Root};
use crate::nodes::{DefaultValue, Definition, Input};
use crate::values::Type;

use super::dead::mark_dead;
use super::diagram::{Card, Dead, Diagram, Given, InputSocket, OutputSocket, Role, Wire};
use super::error::ShowError;
use super::expressions::close;
use super::implied::{badge, implied};
use super::values::{self, Value};

/// What is drawn of `graph`, unless that would be more than `limit` cards: a box for each expression.
pub(super) fn diagram(graph: &Graph, limit: usize) -> Result<Diagram<'_>, ShowError> {
    Ok(close(&open_diagram(graph, limit)?, graph))
}

/// The same with the nodes that expressions became.
pub(super) fn open_diagram(graph: &Graph, limit: usize) -> Result<Diagram<'_>, ShowError> {
    let ends = graph.roots.len() + graph.outputs.len();
    let boxes = graph.parameters.len() + graph.nodes.len() + ends;
    if boxes > limit {
        return Err(ShowError::TooManyBoxes { boxes, limit });
    }
    let builder = Builder { graph, definitions: definitions(graph)? };
    builder.require_bindings()?;
    Ok(builder.diagram())
}

/// The definition of each node.
fn definitions(graph: &Graph) -> Result<Vec<&Definition>, ShowError> {
    let library = &graph.library;
    let known = library.iter().count();
    graph
        .nodes
        .iter()
        .map(|node| {
            if node.node_type.0 >= known {
                return Err(inconsistent(&node.name, "its type is unknown"));
            }
            let definition = library.definition(node.node_type);
            if node.inputs.len() != definition.signature.inputs.len()
                || node.overload >= definition.overloads.len()
            {
                return Err(inconsistent(&node.name, "its inputs are not those of its type"));
            }
            Ok(definition)
        })
        .collect()
}

fn inconsistent(place: &str, problem: &str) -> ShowError {
    ShowError::Inconsistent { place: place.to_owned(), problem: problem.to_owned() }
}

/// A card at the right.
fn end_card<'a>(
    title: &'a str,
    subtitle: &'a str,
    doc: &'a str,
    inputs: Vec<InputSocket>,
) -> Card<'a> {
    Card {
        role: Role::Root,
        title,
        subtitle,
        doc,
        badge: None,
        dead: None,
        value: None,
        inputs,
        outputs: Vec::new(),
        opens: None,
    }
}

struct Builder<'a> {
    graph: &'a Graph,
    definitions: Vec<&'a Definition>,
}

impl<'a> Builder<'a> {
    fn require_bindings(&self) -> Result<(), ShowError> {
        let require = |place: &str, binding: &Binding| match *binding {
            Binding::Parameter(at) if at >= self.graph.parameters.len() => {
                Err(inconsistent(place, "it names a parameter that does not exist"))
            }
            Binding::Node { node, output } => match self.definitions.get(node) {
                Some(definition) if output < definition.signature.outputs.len() => Ok(()),
                _ => Err(inconsistent(place, "it names an output that does not exist")),
            },
            _ => Ok(()),
        };
        for node in &self.graph.nodes {
            node.inputs.iter().try_for_each(|binding| require(&node.name, binding))?;
        }
        for root in &self.graph.roots {
            require(root.kind.name(), &root.color)?;
            require(root.kind.name(), &root.ok)?;
        }
        for output in &self.graph.outputs {
            require(&output.name, &output.value)?;
        }
        Ok(())
    }

    fn diagram(&self) -> Diagram<'a> {
        let parameters = self.graph.parameters.len();
        let nodes = self.graph.nodes.len();
        let mut cards: Vec<Card<'a>> = Vec::with_capacity(parameters + nodes);
        cards.extend((0..parameters).map(|at| self.parameter_card(at)));
        cards.extend((0..nodes).map(|at| self.node_card(at)));
        cards.extend(self.graph.roots.iter().map(|root| self.root_card(root)));
        cards.extend(self.graph.outputs.iter().map(|output| self.output_card(output)));
        let mut diagram =
            Diagram { name: &self.graph.name, cards, wires: Vec::new(), parameters, nodes };
        self.connect(&mut diagram);
        mark_dead(&mut diagram);
        diagram
    }

    fn parameter_card(&self, at: usize) -> Card<'a> {
        let parameter = &self.graph.parameters[at];
        Card {
            role: Role::Parameter,
            title: &parameter.name,
            subtitle: parameter.value_type.name(),
            doc: &parameter.doc,
            badge: None,
            dead: Some(Dead::Unreached),
            value: Some(values::literal(&parameter.default)),
            inputs: Vec::new(),
            outputs: vec![OutputSocket { name: "", value_type: parameter.value_type }],
            opens: None,
        }
    }

    fn node_card(&self, at: usize) -> Card<'a> {
        let (node, definition) = (&self.graph.nodes[at], self.definitions[at]);
        let signature = &definition.signature;
        let given = signature.inputs.iter().zip(&node.inputs).enumerate();
        let inputs: Vec<InputSocket> =
            given.map(|(k, (input, binding))| self.input((at, k), input, binding)).collect();
        let own = badge(&signature.kind);
        Card {
            role: Role::Node,
            title: &node.name,
            subtitle: &signature.name,
            doc: &signature.doc,
            badge: own.or_else(|| inputs.iter().find_map(InputSocket::asks)),
            dead: Some(Dead::Unreached),
            value: None,
            inputs,
            outputs: Vec::new(),
            opens: None,
        }
    }

    fn root_card(&self, root: &Root) -> Card<'a> {
        let mut inputs = vec![self.end("color", Type::Color, &root.color)];
        if root.ok != Binding::Default {
            inputs.push(self.end("ok", Type::Boolean, &root.ok));
        }
        end_card(root.kind.name(), "root", "", inputs)
    }

    fn output_card(&self, output: &'a Output) -> Card<'a> {
        let value = self.end("value", output.value_type, &output.value);
        end_card(&output.name, "output", &output.doc, vec![value])
    }

    /// What a root or an output reads.
    fn end(&self, name: &'static str, value_type: Type, binding: &Binding) -> InputSocket {
        InputSocket {
            name: name.into(),
            value_type,
            guarded: false,
            scoped: false,
            ruled_out: false,
            given: match self.given(binding) {
                Some(given) => given,
                None => Given::Default(Value::plain("true")),
            },
        }
    }

    fn input(&self, at: (usize, usize), input: &Input, binding: &Binding) -> InputSocket {
        let value_type = self.settled(at.0, input.value_type);
        let stands_in = || match &input.default {
            DefaultValue::Literal(_) | DefaultValue::Required => {
                Given::Default(values::default(&input.default, value_type))
            }
            DefaultValue::State(_) | DefaultValue::Node(_) => {
                Given::Implied(implied(&self.graph.library, &input.default))
            }
        };
        InputSocket {
            name: input.name.clone(),
            value_type,
            guarded: input.guarded,
            scoped: input.scoped,
            ruled_out: self.graph.ruled_out.binary_search(&at).is_ok(),
            given: self.given(binding).unwrap_or_else(stands_in),
        }
    }

    /// What a binding tells of a value; none where it gives nothing.
    fn given(&self, binding: &Binding) -> Option<Given> {
        match binding {
            Binding::Default => None,
            Binding::Literal(literal) => Some(Given::Literal(values::literal(literal))),
            Binding::Parameter(at) => {
                Some(Given::Parameter(self.graph.parameters[*at].name.clone()))
            }
            Binding::Node { .. } => Some(Given::Wire),
        }
    }

    fn settled(&self, at: usize, value_type: Type) -> Type {
        let overload = &self.definitions[at].overloads[self.graph.nodes[at].overload];
        match (value_type, overload.generic) {
            (Type::Generic, Some(generic)) => generic,
            _ => value_type,
        }
    }

    /// Adds the wires, and the outputs they start from in the order of the signature.
    fn connect(&self, diagram: &mut Diagram<'a>) {
        let first_root = diagram.parameters + diagram.nodes;
        let mut ends = Vec::new();
        for (at, node) in self.graph.nodes.iter().enumerate() {
            let bindings = node.inputs.iter().enumerate();
            ends.extend(bindings.map(|(k, binding)| ((diagram.parameters + at, k), binding)));
        }
        for (at, root) in self.graph.roots.iter().enumerate() {
            ends.push(((first_root + at, 0), &root.color));
            ends.push(((first_root + at, 1), &root.ok));
        }
        let first_output = first_root + self.graph.roots.len();
        for (at, output) in self.graph.outputs.iter().enumerate() {
            ends.push(((first_output + at, 0), &output.value));
        }
        let used = self.used_outputs(&ends);
        for (at, used) in used.iter().enumerate() {
            let outputs = &self.definitions[at].signature.outputs;
            let used = outputs.iter().zip(used).filter(|(_, used)| **used);
            let sockets = used.map(|(output, _)| OutputSocket {
                name: &output.name,
                value_type: self.settled(at, output.value_type),
            });
            diagram.cards[diagram.parameters + at].outputs = sockets.collect();
        }
        for (to, binding) in ends {
            let from = match *binding {
                Binding::Parameter(at) => (at, 0),
                Binding::Node { node, output } => {
                    let before = used[node][..output].iter().filter(|used| **used).count();
                    (diagram.parameters + node, before)
                }
                Binding::Default | Binding::Literal(_) => continue,
            };
            let from_type = diagram.cards[from.0].outputs[from.1].value_type;
            let input = &diagram.cards[to.0].inputs[to.1];
            let (converts, ruled_out) = (from_type != input.value_type, input.ruled_out);
            diagram.wires.push(Wire { from, to, converts, dead: true, ruled_out });
        }
    }

    /// For each node and output, whether something is connected to it.
    fn used_outputs(&self, ends: &[((usize, usize), &Binding)]) -> Vec<Vec<bool>> {
        let outputs = self.definitions.iter().map(|definition| definition.signature.outputs.len());
        let mut used: Vec<Vec<bool>> = outputs.map(|count| vec![false; count]).collect();
        for (_, binding) in ends {
            if let Binding::Node { node, output } = **binding {
                used[node][output] = true;
            }
        }
        used
    }
}
