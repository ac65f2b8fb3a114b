//! The monolith of a graph, with the graph's values.

use std::collections::HashSet;

use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::values::Literal;

use super::identity::{NotWrittenByHand, recognise};
use super::library::{MonolithError, find};

/// Why there is no monolith to run instead of a graph.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoMonolith {
    /// None computes what the graph does.
    #[error(transparent)]
    NotWritten(#[from] NotWrittenByHand),
    /// The one there is does not take these values.
    #[error(transparent)]
    Value(#[from] MonolithError),
}

/// The monolith that computes what a graph does. It has defaults of its own, so it is given those of
/// the graph.
///
/// # Errors
/// There is none, or it does not take these values.
pub fn of_graph(
    graph: &Graph,
    mut values: Vec<(String, Literal)>,
) -> Result<Box<dyn Shade>, NoMonolith> {
    let name = recognise(graph)?;
    let given: HashSet<String> = values.iter().map(|(name, _)| name.clone()).collect();
    let defaults = graph.parameters.iter().filter(|of| !given.contains(&of.name));
    values.extend(defaults.map(|of| (of.name.clone(), of.default.clone())));
    let found = find(name, &values).ok_or_else(|| NotWrittenByHand::Unknown(name.to_owned()))?;
    Ok(found?)
}
