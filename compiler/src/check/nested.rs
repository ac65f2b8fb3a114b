//! A phenomenon as others see it that use it.

use std::collections::HashMap;

use crate::graph::{Binding, Graph, Output, Root, RootKind};
use crate::nodes::{self, Definition, Input, Kind, Signature};
use crate::state::Iterated;
use crate::values::{Literal, Name, Type};

use super::shape::Shape;

/// Whether a value is read outside of the loops over each of [`Iterated::ALL`].
pub(super) type OutsideLoops = [bool; Iterated::ALL.len()];

/// A phenomenon that others use.
pub(super) struct Nested {
    /// Checked, and without nested phenomena of its own.
    pub graph: Graph,
    /// How many phenomena are within one another there, itself included.
    pub depth: usize,
    /// For each parameter, whether it is read outside of the phenomenon's loops.
    pub outside_loops: Vec<OutsideLoops>,
    /// The arrays and structs among its parameters.
    pub shapes: Vec<(String, Shape)>,
    /// Positions of its parameters.
    pub positions: HashMap<String, usize>,
    /// For each parameter, whether some node must know it before shading.
    pub fixed: Vec<bool>,
    /// What it yields as a node.
    pub outputs: Vec<Output>,
    /// What each of them rests on.
    rests: Vec<Rest>,
}

/// What an output rests on.
struct Rest {
    /// What it asks for: requests and loops, each once.
    asks: Vec<Kind>,
    /// For each parameter, whether it may be read.
    reads: Vec<bool>,
}

impl Nested {
    /// What others need to know of a phenomenon that was checked.
    pub fn new(
        graph: Graph,
        depth: usize,
        outside_loops: Vec<OutsideLoops>,
        shapes: Vec<(String, Shape)>,
    ) -> Self {
        let names = graph.parameters.iter().enumerate();
        let positions = names.map(|(at, parameter)| (parameter.name.clone(), at)).collect();
        let fixed = find_fixed(&graph);
        let outputs = offered(&graph);
        let rests = outputs.iter().map(|output| Rest::of(&graph, &output.value)).collect();
        Self { graph, depth, outside_loops, shapes, positions, fixed, outputs, rests }
    }

    /// What an output asks for; what any of them does where it is not known which.
    pub fn asks(&self, output: Option<usize>) -> impl Iterator<Item = &Kind> {
        let rests = self.rests.iter().enumerate();
        let meant = rests.filter(move |(at, _)| output.is_none_or(|output| output == *at));
        meant.flat_map(|(_, rest)| &rest.asks)
    }

    /// Whether an output may read a parameter. One that declares no outputs has its root's value
    /// alone, and all its parameters count as read.
    pub fn reads(&self, output: usize, parameter: usize) -> bool {
        self.graph.outputs.is_empty() || self.rests[output].reads[parameter]
    }

    /// The node type it is under a name: its parameters are the inputs.
    pub fn definition(&self, name: impl Into<Name>) -> Definition {
        let inputs: Vec<Input> = self
            .graph
            .parameters
            .iter()
            .zip(&self.fixed)
            .map(|(parameter, &fixed)| {
                let default = parameter.default.clone();
                let name = parameter.name.clone();
                let input = Input::new(name, &[], parameter.value_type, default);
                let input =
                    input.within(parameter.range.clone()).usually(parameter.soft_range.clone());
                Input {
                    doc: parameter.doc.clone(),
                    fixed,
                    ..input.measured_in(parameter.unit.clone())
                }
            })
            .collect();
        let output = |of: &Output| nodes::Output::new(of.name.clone(), &[&of.doc], of.value_type);
        Definition::without_body(Signature {
            name: name.into(),
            group: "phenomena",
            doc: self.graph.doc.clone(),
            source: "",
            inputs,
            outputs: self.outputs.iter().map(output).collect(),
            kind: Kind::Plain,
            generic: Type::GENERIC.into(),
            or_list: None,
        })
    }
}

/// What a phenomenon yields as a node: the value of its root, and the outputs it declares. One that is
/// called as a part of the root's value is stands in its place.
fn offered(graph: &Graph) -> Vec<Output> {
    let mut offered = Vec::new();
    if let Some(Root { color, ok, .. }) = root(graph) {
        let ok = match ok {
            Binding::Default => Binding::Literal(Literal::Boolean(true)),
            other => other.clone(),
        };
        let doc = "Whether its root yields a value at all.";
        offered.push(output("color", "The value of its root.", Type::Color, color.clone()));
        offered.push(output("ok", doc, Type::Boolean, ok));
    }
    for output in &graph.outputs {
        match offered.iter_mut().find(|of_root| of_root.name == output.name) {
            Some(of_root) => *of_root = output.clone(),
            None => offered.push(output.clone()),
        }
    }
    offered
}

fn output(name: &str, doc: &str, value_type: Type, value: Binding) -> Output {
    Output { name: name.into(), doc: doc.into(), value_type, value }
}

/// The root whose value the phenomenon has as a node: the first there is, as [`RootKind::ALL`] has
/// them, but a texture before all, which is only ever called by other shaders.
fn root(graph: &Graph) -> Option<&Root> {
    let texture = std::iter::once(RootKind::Texture);
    texture.chain(RootKind::ALL).find_map(|kind| graph.root(kind))
}

impl Rest {
    fn of(graph: &Graph, value: &Binding) -> Self {
        let mut rest = Self { asks: Vec::new(), reads: vec![false; graph.parameters.len()] };
        let mut reached = vec![false; graph.nodes.len()];
        let mut pending = vec![value];
        while let Some(binding) = pending.pop() {
            let node = match binding {
                Binding::Node { node, .. } => *node,
                Binding::Parameter(parameter) => {
                    rest.reads[*parameter] = true;
                    continue;
                }
                Binding::Default | Binding::Literal(_) => continue,
            };
            if std::mem::replace(&mut reached[node], true) {
                continue;
            }
            let node = &graph.nodes[node];
            pending.extend(&node.inputs);
            let kind = &graph.library.signature(node.node_type).kind;
            if matches!(kind, Kind::Request(_) | Kind::Loop(..)) && !rest.asks.contains(kind) {
                rest.asks.push(kind.clone());
            }
        }
        rest
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
