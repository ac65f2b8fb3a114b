//! The nodes that take values apart of which a component is connected.

use std::collections::HashMap;

use crate::graph::{Binding, Node, Output, Root};
use crate::nodes::{NodeLibrary, NodeType};

/// Nodes that take values apart, each value once.
#[derive(Default)]
pub(super) struct Splits {
    nodes: Vec<Node>,
    /// By node and output; of parameters by [`PARAMETERS`] and position.
    known: HashMap<(usize, usize), usize>,
}

/// Stands for no node, where parameters are meant.
const PARAMETERS: usize = usize::MAX;

/// Until all is bound, positions from here on are those of nodes that take values apart.
const OPEN: usize = usize::MAX / 2;

impl Splits {
    /// Position of the node of that type that takes a value apart, called so if it is new.
    pub fn node(
        &mut self,
        library: &NodeLibrary,
        node_type: NodeType,
        name: String,
        whole: Binding,
    ) -> usize {
        let of = match whole {
            Binding::Node { node, output } => (node, output),
            Binding::Parameter(parameter) => (PARAMETERS, parameter),
            // Components are taken of nothing else: the literal itself has them.
            Binding::Default | Binding::Literal(_) => (PARAMETERS, PARAMETERS),
        };
        let next = self.nodes.len();
        let at = *self.known.entry(of).or_insert(next);
        if at == next {
            let mut inputs = vec![Binding::Default; library.signature(node_type).inputs.len()];
            inputs[0] = whole;
            self.nodes.push(Node { name, node_type, overload: 0, inputs });
        }
        OPEN + at
    }

    /// Adds the nodes to those of the graph, the first at the position `first`.
    pub fn place(
        self,
        first: usize,
        (nodes, roots, outputs): (&mut Vec<Node>, &mut [Root], &mut [Output]),
    ) {
        if self.nodes.is_empty() {
            return;
        }
        nodes.extend(self.nodes);
        let inputs = nodes.iter_mut().flat_map(|node| &mut node.inputs);
        let roots = roots.iter_mut().flat_map(|root| [&mut root.color, &mut root.ok]);
        let outputs = outputs.iter_mut().map(|output| &mut output.value);
        for binding in inputs.chain(roots).chain(outputs) {
            if let Binding::Node { node, .. } = binding
                && *node >= OPEN
            {
                *node = *node - OPEN + first;
            }
        }
    }
}
