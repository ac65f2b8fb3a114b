//! A phenomenon as others see it that use it.

use std::collections::HashMap;

use crate::graph::{Binding, Graph, Root, RootKind};
use crate::nodes::{Definition, Input, Kind, Output, Signature};
use crate::state::Iterated;
use crate::values::Type;

use super::shape::Shape;

/// Whether a value is read outside of the loops over each of [`Iterated::ALL`].
pub(super) type OutsideLoops = [bool; Iterated::ALL.len()];

/// A phenomenon that others use.
pub(super) struct Nested {
    /// Checked, and without nested phenomena of its own.
    pub graph: Graph,
    /// For each parameter, whether it is read outside of the phenomenon's loops.
    pub outside_loops: Vec<OutsideLoops>,
    /// The arrays and structs among its parameters.
    pub shapes: Vec<(String, Shape)>,
    /// Positions of its parameters.
    pub positions: HashMap<String, usize>,
    /// For each parameter, whether some node must know it before shading.
    pub fixed: Vec<bool>,
    /// What it asks below the root whose value it has as a node: requests and loops, each once.
    pub asks: Vec<Kind>,
}

impl Nested {
    /// What others need to know of a phenomenon that was checked.
    pub fn new(
        graph: Graph,
        outside_loops: Vec<OutsideLoops>,
        shapes: Vec<(String, Shape)>,
    ) -> Self {
        let names = graph.parameters.iter().enumerate();
        let positions = names.map(|(at, parameter)| (parameter.name.clone(), at)).collect();
        let fixed = find_fixed(&graph);
        let asks = Vec::new();
        let mut nested = Self { graph, outside_loops, shapes, positions, fixed, asks };
        nested.asks = nested.find_asks();
        nested
    }

    fn find_asks(&self) -> Vec<Kind> {
        let mut asks: Vec<Kind> = Vec::new();
        let mut reached = vec![false; self.graph.nodes.len()];
        let mut pending: Vec<&Binding> =
            self.root().map_or(Vec::new(), |root| vec![&root.color, &root.ok]);
        while let Some(binding) = pending.pop() {
            let Binding::Node { node, .. } = binding else { continue };
            if std::mem::replace(&mut reached[*node], true) {
                continue;
            }
            let node = &self.graph.nodes[*node];
            pending.extend(&node.inputs);
            let kind = &self.graph.library.signature(node.node_type).kind;
            if matches!(kind, Kind::Request(_) | Kind::Loop(..)) && !asks.contains(kind) {
                asks.push(kind.clone());
            }
        }
        asks
    }

    /// The root whose value the phenomenon has as a node: the first there is, as [`RootKind::ALL`]
    /// has them, but a texture before all, which is only ever called by other shaders.
    pub fn root(&self) -> Option<&Root> {
        let texture = std::iter::once(RootKind::Texture);
        texture.chain(RootKind::ALL).find_map(|kind| self.graph.root(kind))
    }

    /// The node type it is under the path of its file: its parameters are the inputs, its root's color
    /// and ok the outputs.
    pub fn definition(&self, path: String) -> Definition {
        let inputs: Vec<Input> = self
            .graph
            .parameters
            .iter()
            .zip(&self.fixed)
            .map(|(parameter, &fixed)| {
                let default = parameter.default.clone();
                let name = parameter.name.clone();
                let input = Input::new(name, &[], parameter.value_type, default);
                Input { doc: parameter.doc.clone(), fixed, ..input.within(parameter.range.clone()) }
            })
            .collect();
        Definition::without_body(Signature {
            name: path.into(),
            group: "phenomena",
            doc: self.graph.doc.clone(),
            source: "",
            inputs,
            outputs: vec![
                Output::new("color", &["The value of its root."], Type::Color),
                Output::new("ok", &["Whether its root yields a value at all."], Type::Boolean),
            ],
            kind: Kind::Plain,
        })
    }
}

/// For each parameter, whether an input takes it that is known before shading.
fn find_fixed(graph: &Graph) -> Vec<bool> {
    let mut fixed = vec![false; graph.parameters.len()];
    for node in &graph.nodes {
        let inputs = &graph.library.signature(node.node_type).inputs;
        for (input, binding) in inputs.iter().zip(&node.inputs) {
            if let (true, Binding::Parameter(parameter)) = (input.fixed, binding) {
                fixed[*parameter] = true;
            }
        }
    }
    fixed
}
