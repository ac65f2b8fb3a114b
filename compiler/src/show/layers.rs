//! In which column each card stands: parameters at the left, roots at the right, and every wire
//! runs to the right.

use super::diagram::{Diagram, Role};

/// How often cards are moved to where their wires are shorter.
const ROUNDS: usize = 4;
/// What a wire between nodes costs per column, against one for a parameter's wire.
const NODE_WIRE: i64 = 3;

/// The column of each card; if the wires form a cycle, a card on or behind it.
pub(super) fn layers(diagram: &Diagram<'_>) -> Result<Vec<usize>, usize> {
    let graph = Adjacency::new(diagram);
    let order = topological(&graph)?;
    let mut layers = vec![0_usize; diagram.cards.len()];
    for &card in &order {
        let before = graph.sources[card].iter().map(|&(source, _)| layers[source] + 1);
        // The first column is the interface's, as long as there is one.
        let first = usize::from(diagram.parameters > 0 && card >= diagram.parameters);
        layers[card] = before.max().unwrap_or(0).max(first);
    }
    let last_node = (0..diagram.parameters + diagram.nodes).map(|card| layers[card]).max();
    let root_layer = last_node.map_or(0, |layer| layer + 1);
    for (card, layer) in layers.iter_mut().enumerate() {
        if diagram.cards[card].role == Role::Root {
            *layer = root_layer;
        }
    }
    for _ in 0..ROUNDS {
        shorten(diagram, &graph, &order, &mut layers);
    }
    Ok(layers)
}

/// Wires by their ends.
struct Adjacency {
    /// Per card, where its inputs come from, with the cost of a column.
    sources: Vec<Vec<(usize, i64)>>,
    /// Per card, where its outputs go to.
    targets: Vec<Vec<(usize, i64)>>,
}

impl Adjacency {
    fn new(diagram: &Diagram<'_>) -> Self {
        let mut sources = vec![Vec::new(); diagram.cards.len()];
        let mut targets = vec![Vec::new(); diagram.cards.len()];
        for wire in &diagram.wires {
            let (from, to) = (wire.from.0, wire.to.0);
            let cost = if diagram.cards[from].role == Role::Parameter { 1 } else { NODE_WIRE };
            sources[to].push((from, cost));
            targets[from].push((to, cost));
        }
        Self { sources, targets }
    }
}

/// Cards so that each stands behind its sources (Kahn's algorithm, first come first served).
fn topological(graph: &Adjacency) -> Result<Vec<usize>, usize> {
    let mut missing: Vec<usize> = graph.sources.iter().map(Vec::len).collect();
    let mut order: Vec<usize> = (0..missing.len()).filter(|&card| missing[card] == 0).collect();
    let mut next = 0;
    while let Some(&card) = order.get(next) {
        next += 1;
        for &(target, _) in &graph.targets[card] {
            missing[target] -= 1;
            if missing[target] == 0 {
                order.push(target);
            }
        }
    }
    match missing.iter().position(|&missing| missing > 0) {
        Some(card) => Err(card),
        None => Ok(order),
    }
}

/// Moves each node between its sources and its targets to where its wires are shortest.
fn shorten(diagram: &Diagram<'_>, graph: &Adjacency, order: &[usize], layers: &mut [usize]) {
    for &card in order.iter().rev() {
        if diagram.cards[card].role != Role::Node {
            continue;
        }
        let cost = |ends: &[(usize, i64)]| ends.iter().map(|&(_, cost)| cost).sum::<i64>();
        let before = graph.sources[card].iter().map(|&(source, _)| layers[source] + 1).max();
        let after = graph.targets[card].iter().map(|&(target, _)| layers[target] - 1).min();
        let pull = cost(&graph.targets[card]) - cost(&graph.sources[card]);
        match (before, after) {
            (_, Some(after)) if pull > 0 => layers[card] = after,
            (Some(before), _) if pull < 0 => layers[card] = before,
            _ => {}
        }
    }
}
