//! Graphs with one of their nodes to be looked at.

use phenomenon_compiler::graph::{Graph, RootKind};

use super::error::ShowNodeError;
use super::node_path::NodePath;

/// The graph with one of its nodes for the root that is called.
///
/// # Errors
/// There is no such node, or it has no value to look at.
pub fn shown_node(graph: &Graph, path: &NodePath, root: RootKind) -> Result<Graph, ShowNodeError> {
    let (node, output) =
        path.find(graph).map_err(|error| ShowNodeError::Missing { path: path.clone(), error })?;
    let mut shown = graph.with_root(node, output.unwrap_or(0))?;
    if root != RootKind::Material
        && let Some(mut looked_at) = shown.roots.pop()
    {
        looked_at.kind = root;
        shown.roots.retain(|other| other.kind != root);
        shown.roots.push(looked_at);
    }
    Ok(shown)
}
