//! All engines give the same results and ask the same of the renderer.

use crate::graph::{Binding, Graph};
use crate::nodes::{Kind, NodeLibrary, NodeType};

use super::differential::{Agreement, Case};
use super::print::graph_text;
use super::random::Random;
use super::random_graph::{random_graph, random_graph_of};
use super::shrink::shrink;
use super::subjects::Subjects;

/// Graphs tried for each node.
const CASES: usize = 25;
/// Graphs drawn for a case, until the node stands below a root.
const DRAWS: usize = 40;

/// The random case of a seed.
pub fn random_case(seed: u64, library: &NodeLibrary) -> Case {
    let mut random = Random::new(seed);
    let size = 1 + random.below(if random.clone().chance(30) { 12 } else { 60 });
    let (graph, values) = random_graph(&mut random, library, size);
    Case::random(&mut random, graph, values)
}

/// What came of a case in which nothing differed.
///
/// # Panics
/// If something did: with a small case that does.
pub fn agreed(seed: u64, case: &Case) -> Agreement {
    match case.check() {
        Ok(agreement) => agreement,
        Err(error) => {
            let (small, error) = shrink(case, error);
            let text = graph_text(&small.graph);
            let Case { values, points, .. } = small;
            panic!(
                "seed {seed}: {error}\n{text}values {values:?}\n{} points: {:?}",
                points.len(),
                points[0]
            );
        }
    }
}

/// On random graphs with the node, engines and the definition agree.
///
/// # Panics
/// If they do not, or if there are no such graphs.
pub fn engines_agree_on_graphs_with_the_node(subjects: &Subjects) {
    for (node_type, definition) in subjects.iter() {
        let signature = &definition.signature;
        if matches!(signature.kind, Kind::List(_)) {
            // The checker makes other nodes of it.
            continue;
        }
        let mut ran = 0;
        for seed in 0..CASES as u64 {
            let case = case_with(seed, subjects.library(), node_type);
            let agreement = case.map(|case| agreed(seed, &case)).unwrap_or_default();
            ran += usize::from(agreement.ran && agreement.naive);
        }
        assert!(ran * 3 >= CASES, "{}: {ran} of {CASES} graphs with it were run", signature.name);
    }
}

/// A random case in which a root reaches a node of the type.
fn case_with(seed: u64, library: &NodeLibrary, node_type: NodeType) -> Option<Case> {
    let mut random = Random::new(seed);
    (0..DRAWS).find_map(|_| {
        let size = 1 + random.below(16);
        let (graph, values) = random_graph_of(&mut random, library, size, node_type);
        reaches(&graph, node_type).then(|| Case::random(&mut random, graph, values))
    })
}

fn reaches(graph: &Graph, node_type: NodeType) -> bool {
    let mut seen = vec![false; graph.nodes.len()];
    let mut waiting: Vec<&Binding> =
        graph.roots.iter().flat_map(|root| [&root.color, &root.ok]).collect();
    while let Some(binding) = waiting.pop() {
        let &Binding::Node { node, .. } = binding else { continue };
        if std::mem::replace(&mut seen[node], true) {
            continue;
        }
        if graph.nodes[node].node_type == node_type {
            return true;
        }
        waiting.extend(&graph.nodes[node].inputs);
    }
    false
}
