//! A graph made ready: with the nodes that inputs imply, and what each node reads of the state.

use std::collections::HashMap;

use crate::graph::{Binding, Graph, Node};
use crate::nodes::{DefaultValue, NodeLibrary};
use crate::values::{Literal, Type};

use crate::testing::reads::{self, Fields};

/// Evaluates roots of a graph.
pub struct Naive<'a> {
    pub(super) library: &'a NodeLibrary,
    /// The nodes of the graph, then those that inputs imply.
    pub(super) nodes: Vec<Node>,
    pub(super) implied: HashMap<&'static str, usize>,
    pub(super) reads: Vec<Option<Fields>>,
    pub(super) parameters: Vec<Literal>,
}

/// Evaluation took more steps than allowed.
#[derive(Debug, PartialEq, Eq)]
pub struct TooLong;

impl<'a> Naive<'a> {
    /// With values for parameters, of their types.
    pub fn new(graph: &'a Graph, values: &[(String, Literal)]) -> Self {
        let library = &graph.library;
        let mut parameters: Vec<Literal> =
            graph.parameters.iter().map(|parameter| parameter.default.clone()).collect();
        for (name, value) in values {
            let at = graph.parameter(name).expect("values are of parameters of the graph");
            parameters[at] = value.clone();
        }
        let mut nodes = graph.nodes.clone();
        let mut implied = HashMap::new();
        let mut at = 0;
        while at < nodes.len() {
            let node = nodes[at].clone();
            let inputs = &library.signature(node.node_type).inputs;
            for (input, binding) in inputs.iter().zip(&node.inputs) {
                if let (DefaultValue::Node(name), Binding::Default) = (&input.default, binding) {
                    implied.entry(*name).or_insert_with(|| {
                        nodes.push(reads::implied(library, name));
                        nodes.len() - 1
                    });
                }
            }
            at += 1;
        }
        let mut naive =
            Self { library, reads: vec![None; nodes.len()], nodes, implied, parameters };
        for node in 0..naive.nodes.len() {
            naive.settle_reads(node);
        }
        naive
    }

    fn settle_reads(&mut self, node: usize) {
        if self.reads[node].is_some() {
            return;
        }
        for binding in self.nodes[node].inputs.clone() {
            if let Binding::Node { node, .. } = binding {
                self.settle_reads(node);
            }
        }
        let of_output = |source: usize, output: usize| {
            let whole = self.reads[source].clone().unwrap_or_default();
            reads::of_output(self.library, &self.nodes[source], output, &whole)
        };
        self.reads[node] = Some(reads::of_node(self.library, &self.nodes[node], &of_output));
    }

    pub(super) fn value_type(&self, node: &Node, of: Type) -> Type {
        let generic = self.library.definition(node.node_type).overloads[node.overload].generic;
        if of == Type::Generic { generic.unwrap_or(of) } else { of }
    }
}
