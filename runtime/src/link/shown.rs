//! Graphs with one of their nodes to be looked at.

use phenomenon_compiler::graph::{Graph, RootKind};

use super::error::ShowNodeError;
use super::node_path::NodePath;

/// The graph with one of its nodes, or one of its outputs, for the root that is called.
///
/// # Errors
/// There is no such node or output, or it has no value to look at.
pub fn shown_node(graph: &Graph, path: &NodePath, root: RootKind) -> Result<Graph, ShowNodeError> {
    let mut shown = match path.find_output(graph) {
        Some(output) => graph.with_output(output)?,
        None => {
            let missing = |error| ShowNodeError::Missing { path: path.clone(), error };
            let (node, output) = path.find(graph).map_err(missing)?;
            graph.with_root(node, output.unwrap_or(0))?
        }
    };
    if root != RootKind::Material
        && let Some(mut looked_at) = shown.roots.pop()
    {
        looked_at.kind = root;
        shown.roots.retain(|other| other.kind != root);
        shown.roots.push(looked_at);
    }
    Ok(shown)
}
