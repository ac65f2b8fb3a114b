//! Everything of a phenomenon bound to its source.

use crate::diagnostics::Code;
use crate::document::{Reader, Value};
use crate::graph::{Node, Output, Root};

use super::draft::Draft;
use super::limits::MAX_NODES;
use super::types::Types;
use super::{bind_inputs, implied_scopes, outputs};

/// What a phenomenon becomes.
pub(super) struct Bound {
    /// Those of the file, then those that lists, components, and inputs left out stand for.
    pub nodes: Vec<Node>,
    pub roots: Vec<Root>,
    pub outputs: Vec<Output>,
}

/// Binds a draft; `phenomenon` is where it is declared.
pub(super) fn bind<'d>(
    reader: &mut Reader<'d>,
    phenomenon: &Value,
    draft: &Draft<'d>,
    types: &Types,
) -> Bound {
    let (nodes, roots, own) = bind_inputs::bind(reader, draft, types);
    let outputs = outputs::bind(reader, draft, types);
    let mut bound = Bound { nodes, roots, outputs };
    // Positions are counted as if each node of the file were bound: else there is no graph.
    let first = draft.nodes.len() + bound.nodes.len() - own;
    let splits = draft.splits.take();
    splits.place(first, (&mut bound.nodes, &mut bound.roots, &mut bound.outputs));
    implied_scopes::add(&draft.node_types, &mut bound.nodes);
    if bound.nodes.len() > MAX_NODES {
        let message = format!(
            "with those that stand for lists the graph has {} nodes; at most {MAX_NODES} are allowed",
            bound.nodes.len()
        );
        let place = phenomenon.get("nodes").unwrap_or(phenomenon);
        let help = "give `element` and `sum` fewer values";
        reader.report(Code::TOO_MANY_NODES, place, message, help);
    }
    bound
}
