//! Putting nested phenomena in the place of the nodes that use them.

use std::rc::Rc;

use crate::diagnostics::Code;
use crate::document::Reader;
use crate::graph::{Binding, Graph, Node, Root};
use crate::nodes::NodeLibrary;
use crate::values::{Literal, Type};

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

/// The graph with every nested phenomenon expanded; none, and a finding, where it grows too large.
pub(super) fn expand(reader: &mut Reader<'_>, draft: &Draft<'_>, graph: Graph) -> Option<Graph> {
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
        let root = &reader.document.root;
        let place = reader.document.root.get("nodes").unwrap_or(root);
        reader.report(Code::TOO_MANY_NODES, place, message, "use fewer phenomena, or smaller ones");
        return None;
    }
    let known = vec![[None, None]; graph.nodes.len()];
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
    let mut roots = Vec::with_capacity(graph.roots.len());
    for root in &graph.roots {
        let color = expansion.resolve(None, &root.color, Type::Color);
        let ok = expansion.resolve(None, &root.ok, Type::Boolean);
        roots.push(Root { kind: root.kind, color, ok });
    }
    drop(expansion);
    Some(Graph { nodes, roots, ruled_out, ..graph })
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
    known: Vec<[Option<Binding>; 2]>,
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
        let truth = Binding::Literal(Literal::Boolean(true));
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
                        binding = match (nested.root(), output) {
                            (Some(root), 0) => &root.color,
                            (Some(Root { ok: Binding::Default, .. }), _) | (None, _) => &truth,
                            (Some(root), _) => &root.ok,
                        };
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
