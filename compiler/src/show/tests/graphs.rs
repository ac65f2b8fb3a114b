//! Graphs that are drawn.

use proptest::prelude::*;

use crate::graph::{Binding, Graph, Node, Parameter, Root, RootKind};
use crate::nodes::NodeLibrary;
use crate::values::{Literal, Type};

pub fn empty(name: &str) -> Graph {
    let library = NodeLibrary::standard();
    Graph { library, name: name.into(), version: 1, ..Graph::default() }
}

pub fn node(library: &NodeLibrary, node_type: &str, name: &str, given: &[(&str, Binding)]) -> Node {
    let node_type = library.find(node_type).expect("a node of the library");
    let signature = library.signature(node_type);
    let mut inputs = vec![Binding::Default; signature.inputs.len()];
    for (input, binding) in given {
        inputs[signature.input(input).expect("an input of the node")] = binding.clone();
    }
    Node { name: name.into(), node_type, overload: 0, inputs }
}

pub fn from(node: usize, output: usize) -> Binding {
    Binding::Node { node, output }
}

pub fn root(kind: RootKind, color: Binding) -> Root {
    Root { kind, color, ok: Binding::Default }
}

/// A mirror in a scope, mixed with a parameter, and a node nothing reaches.
pub fn small() -> Graph {
    let mut graph = empty("small");
    let library = &graph.library.clone();
    graph.parameters = vec![
        Parameter::new("tint", Literal::Color([0.9, 0.7, 0.4, 1.0])),
        Parameter::new("unused", Literal::Scalar(1.0)),
    ];
    graph.nodes = vec![
        node(library, "trace_reflection", "mirror", &[]),
        node(library, "perturb_normal", "bumped", &[("input", from(0, 0))]),
        node(
            library,
            "mix",
            "shade",
            &[("weight", from(0, 3)), ("a", from(1, 0)), ("b", Binding::Parameter(0))],
        ),
        node(library, "add", "lost", &[("a", from(0, 3))]),
    ];
    graph.nodes[2].overload = color_overload(library, "mix");
    graph.roots = vec![root(RootKind::Material, from(2, 0)), root(RootKind::Shadow, from(0, 3))];
    graph
}

pub fn color_overload(library: &NodeLibrary, name: &str) -> usize {
    let definition = library.definition(library.find(name).expect("a node of the library"));
    let color = Some(Type::Color);
    definition
        .overloads
        .iter()
        .position(|overload| overload.generic == color)
        .expect("a colour form")
}

pub fn chain(length: usize) -> Graph {
    let mut graph = empty("chain");
    let library = &graph.library.clone();
    graph.parameters = vec![Parameter::new("step", Literal::Scalar(0.5))];
    for at in 0..length {
        let before = at.checked_sub(1).map_or(Binding::Default, |before| from(before, 0));
        let given = [("a", before), ("b", Binding::Parameter(0))];
        graph.nodes.push(node(library, "add", &format!("n{at}"), &given));
    }
    graph.roots = vec![root(RootKind::Material, from(length - 1, 0))];
    graph
}

/// A mix of weight 0 that never asks for its mirror; the other half is a lambert turned away from
/// its light, which asks neither the light nor its colour.
pub fn ruled_out() -> Graph {
    let mut graph = empty("ruled_out");
    let library = &graph.library.clone();
    graph.parameters = vec![
        Parameter::new("tint", Literal::Color([0.9, 0.7, 0.4, 1.0])),
        Parameter::new("share", Literal::Scalar(0.0)),
    ];
    let away = [0.0, -0.0, -1.0];
    graph.nodes = vec![
        node(library, "trace_reflection", "mirror", &[]),
        node(
            library,
            "lambert",
            "turned_away",
            &[
                ("normal", Binding::Literal(Literal::Vector([0.0, 0.0, 1.0]))),
                ("direction", Binding::Literal(Literal::Vector(away))),
                ("color", Binding::Parameter(0)),
            ],
        ),
        node(library, "lambert", "facing", &[]),
        node(
            library,
            "mix",
            "constant",
            &[
                ("weight", Binding::Literal(Literal::Scalar(-0.0))),
                ("a", from(1, 0)),
                ("b", from(0, 0)),
            ],
        ),
        node(
            library,
            "mix",
            "live",
            &[("weight", Binding::Parameter(1)), ("a", from(3, 0)), ("b", from(2, 0))],
        ),
    ];
    for at in [3, 4] {
        graph.nodes[at].overload = color_overload(library, "mix");
    }
    graph.roots = vec![root(RootKind::Material, from(4, 0))];
    // What the checker would say of it.
    graph.ruled_out = vec![(1, 2), (1, 3), (3, 2)];
    graph
}

/// A random graph of mixes, sums and traces; each node takes from nodes before it.
pub fn random_graph() -> impl Strategy<Value = Graph> {
    let picks =
        prop::collection::vec((0..5_usize, prop::collection::vec(0..1_000_usize, 6)), 1..60);
    (picks, 0..6_usize).prop_map(|(picks, parameters)| {
        let types = ["mix", "add", "trace_reflection", "perturb_normal", "light_loop"];
        let mut graph = empty("random");
        let library = graph.library.clone();
        for at in 0..parameters {
            graph.parameters.push(Parameter::new(format!("p{at}"), Literal::Scalar(at as f32)));
        }
        for (at, (kind, sources)) in picks.iter().enumerate() {
            let mut node = node(&library, types[*kind], &format!("node_{at}"), &[]);
            for (input, &source) in node.inputs.iter_mut().zip(sources) {
                *input = match source % 4 {
                    0 if parameters > 0 => Binding::Parameter(source % parameters),
                    1 | 2 if at > 0 => {
                        let from = source % at;
                        let outputs = library.signature(graph.nodes[from].node_type).outputs.len();
                        Binding::Node { node: from, output: source / 7 % outputs }
                    }
                    _ => Binding::Default,
                };
            }
            graph.nodes.push(node);
        }
        graph.roots = vec![
            root(RootKind::Material, from(picks.len() - 1, 0)),
            root(RootKind::Shadow, from(picks.len() / 2, 0)),
        ];
        graph
    })
}
