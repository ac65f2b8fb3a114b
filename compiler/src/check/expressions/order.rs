//! In which order nodes and expressions come to be known: each after what it reads.

use std::collections::{HashMap, VecDeque};

use crate::check::draft::Draft;
use crate::document::expression::PartKind;

use super::parsed::{Bound, Parsed};

/// A node, or an expression, by position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Item {
    /// A node whose type is known by now.
    Node(usize),
    /// An expression.
    Expression(usize),
    /// An expression that reads itself, or what does.
    Circular(usize),
}

/// All expressions, and the nodes that are known before them. Iterative, for chains are as long as files.
pub(super) fn order(draft: &Draft<'_>, parsed: &[Parsed<'_>]) -> Vec<Item> {
    let (nodes, count) = (draft.nodes.len(), draft.nodes.len() + parsed.len());
    let mut readers: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut waiting = vec![0_usize; count];
    let mut reads = |reader: usize, source: usize| {
        readers[source].push(reader);
        waiting[reader] += 1;
    };
    for node in 0..nodes {
        draft.reads(node).for_each(|(source, _)| reads(node, source));
    }
    for (at, expression) in parsed.iter().enumerate() {
        read_nodes(draft, expression).into_iter().for_each(|source| reads(nodes + at, source));
        expression.nodes.iter().for_each(|&node| reads(node, nodes + at));
    }
    let mut ready: VecDeque<usize> = (0..count).filter(|&at| waiting[at] == 0).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(at) = ready.pop_front() {
        order.push(match at.checked_sub(nodes) {
            Some(expression) => Item::Expression(expression),
            None => Item::Node(at),
        });
        for &reader in &readers[at] {
            waiting[reader] -= 1;
            if waiting[reader] == 0 {
                ready.push_back(reader);
            }
        }
    }
    let circular = (0..parsed.len()).filter(|at| waiting[nodes + at] > 0);
    order.extend(circular.map(Item::Circular));
    order
}

/// The nodes an expression reads, ascending.
pub(super) fn read_nodes(draft: &Draft<'_>, expression: &Parsed<'_>) -> Vec<usize> {
    let mut found = Vec::new();
    let mut bound = HashMap::new();
    collect(draft, expression, &mut bound, &mut found);
    found.sort_unstable();
    found.dedup();
    found
}

/// Adds the nodes below an expression. `bound` counts how often a name is bound round it.
fn collect<'p>(
    draft: &Draft<'_>,
    expression: &'p Parsed<'_>,
    bound: &mut HashMap<&'p str, usize>,
    found: &mut Vec<usize>,
) {
    for (member, value) in &expression.bindings {
        match value {
            Bound::Expression(inner) => collect(draft, inner, bound, found),
            Bound::Value(value) => {
                if let Some(crate::document::ValueKind::String(name)) =
                    value.get("node").map(|node| &node.kind)
                {
                    found.extend(draft.nodes_named(name));
                }
            }
        }
        *bound.entry(&member.key).or_default() += 1;
    }
    for part in &expression.parts {
        if let PartKind::Name(name) = &part.kind
            && bound.get(name.as_str()).is_none_or(|count| *count == 0)
        {
            found.extend(draft.nodes_named(name));
        }
    }
    for (member, _) in &expression.bindings {
        if let Some(count) = bound.get_mut(member.key.as_str()) {
            *count -= 1;
        }
    }
}
