//! Under which conditions nodes are evaluated: what is true of a value wherever it may be read need
//! not be true where it is.
//!
//! `select(0 < d, 1 / d, 0)` never divides by zero: the division is evaluated where the condition
//! holds only. So a complaint about a node is made only if the guards on the way to it do not depend on
//! the sources the complaint is about.

use crate::check::draft::{Draft, SourceKind};

use super::pass::Guards;
use super::value::ANY_SOURCE;

/// For each node the sources that decide whether it is evaluated; none if it is somewhere
/// unconditionally. `order` has sources before what reads them.
pub fn conditions(draft: &Draft<'_>, order: &[usize], guards: &Guards) -> Vec<u64> {
    let mut conditions: Vec<Option<u64>> = vec![None; draft.nodes.len()];
    for source in draft.roots.iter().flat_map(|root| root.sources()) {
        if let SourceKind::Node(node, _) = source.kind {
            conditions[node] = Some(0);
        }
    }
    for &node in order.iter().rev() {
        // What nothing reads is complained of as if it were.
        let own = *conditions[node].get_or_insert(0);
        for input in &draft.nodes[node].inputs {
            let (SourceKind::Node(source, _), Some(at)) = (input.source.kind, input.input) else {
                continue;
            };
            let under = own | guards.condition(node, at);
            conditions[source] = match conditions[source] {
                Some(0) => Some(0),
                _ if under == 0 => Some(0),
                Some(other) => Some(other | under),
                None => Some(under),
            };
        }
    }
    conditions.into_iter().map(|condition| condition.unwrap_or(ANY_SOURCE)).collect()
}
