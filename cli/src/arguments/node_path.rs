//! `--node NODE[.OUTPUT]`.

use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;

use crate::failure::Failure;

/// A node as the user named it, perhaps with one of its outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NodePath(String);

/// Reads `NODE[.OUTPUT]`.
pub fn node_path(text: &str) -> Result<NodePath, String> {
    if text.is_empty() || text.starts_with('.') || text.ends_with('.') {
        return Err("write NODE or NODE.OUTPUT".into());
    }
    Ok(NodePath(text.into()))
}

impl std::fmt::Display for NodePath {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl NodePath {
    /// The object, and the node within its material, of `OBJECT:NODE[.OUTPUT]`; none without a colon.
    /// No node has one in its name; an object may.
    pub fn within_object(&self) -> Option<(String, NodePath)> {
        let (object, node) = self.0.rsplit_once(':')?;
        Some((object.to_owned(), NodePath(node.to_owned())))
    }

    /// Positions of the node and of the output, where one is named.
    ///
    /// # Errors
    /// The graph has no such node, or the node no such output.
    pub fn find(
        &self,
        graph: &Graph,
        library: &NodeLibrary,
    ) -> Result<(usize, Option<usize>), Failure> {
        let Self(path) = self;
        let position = |name: &str| graph.nodes.iter().position(|node| node.name == name);
        // A node's own name may hold a stop.
        if let Some(node) = position(path) {
            return Ok((node, None));
        }
        let (name, output) = match path.rsplit_once('.') {
            Some((name, output)) => (name, Some(output)),
            None => (path.as_str(), None),
        };
        let Some(node) = position(name) else {
            let names = || graph.nodes.iter().map(|node| node.name.as_str());
            let help = match nearest(name, names()) {
                Some(near) => near.help(),
                None => format!("its nodes are {}", some_of(names())),
            };
            let message = format!("--node {path}: `{}` has no node `{name}`", graph.name);
            return Err(Failure::new(message, help));
        };
        let Some(output) = output else { return Ok((node, None)) };
        let signature = library.signature(graph.nodes[node].node_type);
        let Some(output) = signature.output(output) else {
            let names = || signature.outputs.iter().map(|output| output.name);
            let help = match nearest(output, names()) {
                Some(near) => format!("did you mean `{name}.{}`?", near.name),
                None => format!("its outputs are {}", some_of(names())),
            };
            let message =
                format!("--node {path}: `{name}`, a {}, has no output `{output}`", signature.name);
            return Err(Failure::new(message, help));
        };
        Ok((node, Some(output)))
    }
}

/// The first few of many names.
fn some_of<'a>(mut names: impl Iterator<Item = &'a str>) -> String {
    let shown: Vec<String> = names.by_ref().take(8).map(|name| format!("`{name}`")).collect();
    let more = names.count();
    let shown = shown.join(", ");
    if more == 0 { shown } else { format!("{shown} and {more} more") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_may_be_many() {
        assert_eq!(some_of(["a", "b"].into_iter()), "`a`, `b`");
        assert!(some_of(["a"; 20].into_iter()).ends_with("`a` and 12 more"));
    }

    #[test]
    fn half_a_path_is_refused() {
        for text in ["", ".", ".a", "a."] {
            assert!(node_path(text).is_err(), "{text}");
        }
        assert!(node_path("a.b").is_ok());
    }
}
