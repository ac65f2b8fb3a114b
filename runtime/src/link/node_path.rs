//! A node of a graph, as it is named from outside.

use std::fmt;

use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::graph::Graph;

/// `NODE[.OUTPUT]`: a node, perhaps with one of its outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NodePath(String);

/// Why a text names no node of any graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("write NODE or NODE.OUTPUT")]
pub struct HalfNodePath;

/// Why a path leads to no node of a graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoSuchNode {
    /// The graph has no such node.
    #[error("`{graph}` has no node `{node}`")]
    Node {
        /// The graph.
        graph: String,
        /// The name that was given.
        node: String,
        /// What may be meant, or what there is.
        help: String,
    },
    /// The node has no such output.
    #[error("`{node}`, a {node_type}, has no output `{output}`")]
    Output {
        /// The node.
        node: String,
        /// Its type.
        node_type: String,
        /// The name that was given.
        output: String,
        /// What may be meant, or what there is.
        help: String,
    },
}

impl NoSuchNode {
    /// What may be meant, or what there is.
    pub fn help(&self) -> &str {
        match self {
            NoSuchNode::Node { help, .. } | NoSuchNode::Output { help, .. } => help,
        }
    }
}

impl fmt::Display for NodePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl NodePath {
    /// Reads `NODE[.OUTPUT]`.
    ///
    /// # Errors
    /// A part of it is missing.
    pub fn read(text: &str) -> Result<Self, HalfNodePath> {
        if text.is_empty() || text.starts_with('.') || text.ends_with('.') {
            return Err(HalfNodePath);
        }
        Ok(Self(text.into()))
    }

    /// The object, and the node within its material, of `OBJECT:NODE[.OUTPUT]`; none without a colon.
    /// No node has one in its name; an object may.
    pub fn within_object(&self) -> Option<(String, NodePath)> {
        let (object, node) = self.0.rsplit_once(':')?;
        Some((object.to_owned(), NodePath(node.to_owned())))
    }

    /// Position of the output of the phenomenon it names, for want of a node called so.
    pub fn find_output(&self, graph: &Graph) -> Option<usize> {
        let Self(path) = self;
        match graph.nodes.iter().any(|node| node.name == *path) {
            true => None,
            false => graph.outputs.iter().position(|output| output.name == *path),
        }
    }

    /// Positions of the node and of the output, where one is named.
    ///
    /// # Errors
    /// The graph has no such node, or the node no such output.
    pub fn find(&self, graph: &Graph) -> Result<(usize, Option<usize>), NoSuchNode> {
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
            let outputs: Vec<&str> = graph.outputs.iter().map(|it| it.name.as_str()).collect();
            let help = match nearest(name, names().chain(outputs.iter().copied())) {
                Some(near) => near.help(),
                None if outputs.is_empty() => format!("its nodes are {}", some_of(names())),
                None => format!(
                    "its outputs are {}, its nodes {}",
                    some_of(outputs.iter().copied()),
                    some_of(names())
                ),
            };
            return Err(NoSuchNode::Node { graph: graph.name.clone(), node: name.into(), help });
        };
        let Some(output) = output else { return Ok((node, None)) };
        let signature = graph.library.signature(graph.nodes[node].node_type);
        match signature.output(output) {
            Some(output) => Ok((node, Some(output))),
            None => {
                let names = || signature.outputs.iter().map(|output| &*output.name);
                let help = match nearest(output, names()) {
                    Some(near) => format!("did you mean `{name}.{}`?", near.name),
                    None => format!("its outputs are {}", some_of(names())),
                };
                let node_type = signature.name.to_string();
                Err(NoSuchNode::Output {
                    node: name.into(),
                    node_type,
                    output: output.into(),
                    help,
                })
            }
        }
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
            assert_eq!(NodePath::read(text), Err(HalfNodePath), "{text}");
        }
        assert!(NodePath::read("a.b").is_ok());
    }
}
