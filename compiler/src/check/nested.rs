//! A phenomenon as others see it that use it.

use std::collections::{HashMap, HashSet};
use std::sync::{Mutex, OnceLock, PoisonError};

use crate::graph::{Binding, Graph, Root, RootKind};
use crate::nodes::{Definition, Input, Kind, NodeLibrary, Output, Signature};
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
        library: &NodeLibrary,
        graph: Graph,
        outside_loops: Vec<OutsideLoops>,
        shapes: Vec<(String, Shape)>,
    ) -> Self {
        let names = graph.parameters.iter().enumerate();
        let positions = names.map(|(at, parameter)| (parameter.name.clone(), at)).collect();
        let fixed = find_fixed(library, &graph);
        let asks = Vec::new();
        let mut nested = Self { graph, outside_loops, shapes, positions, fixed, asks };
        nested.asks = nested.find_asks(library);
        nested
    }

    fn find_asks(&self, library: &NodeLibrary) -> Vec<Kind> {
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
            let kind = &library.signature(node.node_type).kind;
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
    pub fn definition(&self, path: &str) -> Definition {
        let inputs: Vec<Input> = self
            .graph
            .parameters
            .iter()
            .zip(&self.fixed)
            .map(|(parameter, &fixed)| {
                let default = parameter.default.clone();
                let input =
                    Input::new(interned(&parameter.name), &[], parameter.value_type, default);
                Input { doc: parameter.doc.clone(), fixed, ..input.within(parameter.range.clone()) }
            })
            .collect();
        Definition::without_body(Signature {
            name: interned(path),
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
fn find_fixed(library: &NodeLibrary, graph: &Graph) -> Vec<bool> {
    let mut fixed = vec![false; graph.parameters.len()];
    for node in &graph.nodes {
        let inputs = &library.signature(node.node_type).inputs;
        for (input, binding) in inputs.iter().zip(&node.inputs) {
            if let (true, Binding::Parameter(parameter)) = (input.fixed, binding) {
                fixed[*parameter] = true;
            }
        }
    }
    fixed
}

/// A name that lives as long as the program, as signatures want it. Each different name is kept
/// once, so checking the same files again and again costs nothing more.
fn interned(name: &str) -> &'static str {
    static NAMES: OnceLock<Mutex<HashSet<&'static str>>> = OnceLock::new();
    let names = NAMES.get_or_init(Mutex::default);
    let mut names = names.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name) {
        return known;
    }
    let kept: &'static str = Box::leak(name.to_owned().into_boxed_str());
    names.insert(kept);
    kept
}
