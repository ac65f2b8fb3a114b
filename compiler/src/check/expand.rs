//! Putting nested phenomena in the place of the nodes that use them.

use std::rc::Rc;

use crate::diagnostics::Code;
use crate::document::{Reader, Value};
use crate::graph::{Binding, Expression, Graph, Node, Root};
use crate::nodes::NodeLibrary;
use crate::values::Type;

use super::draft::Draft;
use super::limits::MAX_NODES;
use super::nested::Nested;

/// Where the nodes of the outer graph went.
enum Placed {
    /// One node, at this position.
    Node(usize),
    /// The nodes of a phenomenon, from this position on.
    Phenomenon(usize, Rc<Nested>),
}

impl Placed {
    /// How many outputs lead into it.
    fn outputs(&self) -> usize {
        match self {
            Placed::Node(_) => 0,
            Placed::Phenomenon(_, nested) => nested.outputs.len(),
        }
    }
}

/// The graph with every nested phenomenon expanded; none, and a finding, where it grows too large.
/// `phenomenon` is where it is declared.
pub(super) fn expand(
    reader: &mut Reader<'_>,
    phenomenon: &Value,
    draft: &Draft<'_>,
    graph: Graph,
) -> Option<Graph> {
    let mut places = Vec::with_capacity(graph.nodes.len());
    let mut count = 0_usize;
    for node in &graph.nodes {
        match draft.nested.get(&node.node_type) {
            Some(nested) => {
                places.push(Placed::Phenomenon(count, nested.clone()));
                count = count.saturating_add(nested.graph.nodes.len());
            }
            None => {
                places.push(Placed::Node(count));
                count = count.saturating_add(1);
            }
        }
    }
    if count > MAX_NODES {
        let message = format!(
            "with its nested phenomena the graph has {count} nodes; at most {MAX_NODES} are allowed"
        );
        let place = phenomenon.get("nodes").unwrap_or(phenomenon);
        reader.report(Code::TOO_MANY_NODES, place, message, "use fewer phenomena, or smaller ones");
        return None;
    }
    let known = places.iter().map(|place| vec![None; place.outputs()]).collect();
    let mut expansion = Expansion { outer: &graph, places: &places, known };
    let library = draft.node_types.library;
    let mut nodes = Vec::with_capacity(count);
    for (at, (node, place)) in graph.nodes.iter().zip(&places).enumerate() {
        match place {
            Placed::Node(_) => {
                nodes.push(expansion.node(library, node, None, node.name.clone()));
            }
            Placed::Phenomenon(_, nested) => {
                for inner in &nested.graph.nodes {
                    let name = format!("{}/{}", node.name, inner.name);
                    nodes.push(expansion.node(library, inner, Some(at), name));
                }
            }
        }
    }
    let ruled_out = ruled_out(&graph, &places);
    let expressions = expressions(&graph, &places);
    let mut roots = Vec::with_capacity(graph.roots.len());
    for root in &graph.roots {
        let color = expansion.resolve(None, &root.color, Type::Color);
        let ok = expansion.resolve(None, &root.ok, Type::Boolean);
        roots.push(Root { kind: root.kind, color, ok });
    }
    let mut outputs = graph.outputs.clone();
    for output in &mut outputs {
        output.value = expansion.resolve(None, &output.value, output.value_type);
    }
    drop(expansion);
    Some(Graph { nodes, roots, outputs, ruled_out, expressions, ..graph })
}

/// The expressions of the graph and of its phenomena.
fn expressions(graph: &Graph, places: &[Placed]) -> Vec<Expression> {
    let mut all = graph.expressions.clone();
    for (node, place) in graph.nodes.iter().zip(places) {
        if let Placed::Phenomenon(_, nested) = place {
            all.extend(nested.graph.expressions.iter().map(|inner| Expression {
                name: format!("{}/{}", node.name, inner.name),
                text: inner.text.clone(),
            }));
        }
    }
    all
}

/// What is never evaluated, in the places where the nodes went.
fn ruled_out(graph: &Graph, places: &[Placed]) -> Vec<(usize, usize)> {
    let outer = graph.ruled_out.iter().filter_map(|&(node, input)| match places[node] {
        Placed::Node(at) => Some((at, input)),
        Placed::Phenomenon(..) => None,
    });
    let inner = places.iter().flat_map(|place| {
        let (first, ruled_out) = match place {
            Placed::Node(at) => (*at, &[][..]),
            Placed::Phenomenon(first, nested) => (*first, nested.graph.ruled_out.as_slice()),
        };
        ruled_out.iter().map(move |&(node, input)| (first + node, input))
    });
    let mut all: Vec<(usize, usize)> = outer.chain(inner).collect();
    all.sort_unstable();
    all
}

/// Finds where the bindings of the expanded graph lead.
struct Expansion<'e> {
    outer: &'e Graph,
    places: &'e [Placed],
    /// For each phenomenon, where its outputs lead, once known: phenomena may hand a value on and on,
    /// and each way is walked once.
    known: Vec<Vec<Option<Binding>>>,
}

impl Expansion<'_> {
    /// A node of the outer graph, or of the phenomenon at position `scope` of it, bound anew.
    fn node(
        &mut self,
        library: &NodeLibrary,
        node: &Node,
        scope: Option<usize>,
        name: String,
    ) -> Node {
        let definition = library.definition(node.node_type);
        let generic = definition.overloads[node.overload].generic;
        let inputs =
            definition.signature.inputs.iter().zip(&node.inputs).map(|(input, binding)| {
                let to = match (input.value_type, generic) {
                    (Type::Generic, Some(generic)) => generic,
                    (other, _) => other,
                };
                self.resolve(scope, binding, to)
            });
        let inputs = inputs.collect();
        Node { name, node_type: node.node_type, overload: node.overload, inputs }
    }

    /// Where a binding leads, a literal converted to the type of the input it now feeds.
    fn resolve(&mut self, scope: Option<usize>, binding: &Binding, to: Type) -> Binding {
        match self.follow(scope, binding) {
            Binding::Literal(literal) => {
                Binding::Literal(literal.converted_to(to).unwrap_or(literal))
            }
            other => other,
        }
    }

    /// Follows a binding out of phenomena and into them, until it ends at something that stays.
    fn follow(&mut self, mut scope: Option<usize>, binding: &Binding) -> Binding {
        let (outer, places) = (self.outer, self.places);
        let mut binding = binding;
        let mut passed: Vec<(usize, usize)> = Vec::new();
        let end = loop {
            match (scope, binding) {
                (_, Binding::Default | Binding::Literal(_)) | (None, Binding::Parameter(_)) => {
                    break binding.clone();
                }
                (Some(at), Binding::Parameter(parameter)) => {
                    binding = &outer.nodes[at].inputs[*parameter];
                    scope = None;
                    if let (Binding::Default, Placed::Phenomenon(_, nested)) =
                        (binding, &places[at])
                    {
                        let default = nested.graph.parameters[*parameter].default.clone();
                        break Binding::Literal(default);
                    }
                }
                (Some(at), Binding::Node { node, output }) => {
                    let (Placed::Phenomenon(from, _) | Placed::Node(from)) = &places[at];
                    break Binding::Node { node: from + node, output: *output };
                }
                (None, Binding::Node { node, output }) => match &places[*node] {
                    Placed::Node(at) => break Binding::Node { node: *at, output: *output },
                    Placed::Phenomenon(_, nested) => {
                        if let Some(known) = &self.known[*node][*output] {
                            break known.clone();
                        }
                        passed.push((*node, *output));
                        scope = Some(*node);
                        binding = &nested.outputs[*output].value;
                    }
                },
            }
        };
        for (node, output) in passed {
            self.known[node][output] = Some(end.clone());
        }
        end
    }
}
