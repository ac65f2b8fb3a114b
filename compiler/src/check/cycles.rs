//! The order of evaluation, and cycles, wherever they are.

use std::collections::VecDeque;

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::Reader;

use super::draft::Draft;
use super::limits::MAX_CYCLE_SHOWN;

/// Every node, sources before what reads them. Nodes on a cycle, and what reads them, come last.
/// Each knot of cycles is one finding. Iterative throughout: chains are as long as files.
pub(super) fn order(reader: &mut Reader<'_>, draft: &Draft<'_>) -> Vec<usize> {
    let count = draft.nodes.len();
    let mut readers: Vec<Vec<u32>> = vec![Vec::new(); count];
    let mut waiting_for = vec![0_usize; count];
    for (node, waiting) in waiting_for.iter_mut().enumerate() {
        for (source, _) in draft.reads(node) {
            readers[source].push(node as u32);
            *waiting += 1;
        }
    }
    let mut ready: VecDeque<usize> = (0..count).filter(|&node| waiting_for[node] == 0).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(node) = ready.pop_front() {
        order.push(node);
        for &reader in &readers[node] {
            let waiting = &mut waiting_for[reader as usize];
            *waiting -= 1;
            if *waiting == 0 {
                ready.push_back(reader as usize);
            }
        }
    }
    if order.len() < count {
        let left: Vec<usize> = (0..count).filter(|&node| waiting_for[node] > 0).collect();
        report_knots(reader, draft, &left);
        order.extend(left);
    }
    order
}

fn report_knots(reader: &mut Reader<'_>, draft: &Draft<'_>, left: &[usize]) {
    let mut graph: DiGraph<usize, ()> = DiGraph::with_capacity(left.len(), left.len());
    let mut index = vec![None; draft.nodes.len()];
    for &node in left {
        index[node] = Some(graph.add_node(node));
    }
    for &node in left {
        for (source, _) in draft.reads(node) {
            if let (Some(from), Some(to)) = (index[node], index[source]) {
                graph.add_edge(from, to, ());
            }
        }
    }
    let mut knots: Vec<Vec<NodeIndex>> = kosaraju_scc(&graph);
    knots.retain(|knot| knot.len() > 1 || graph.contains_edge(knot[0], knot[0]));
    let mut knot_of = vec![usize::MAX; draft.nodes.len()];
    for (at, knot) in knots.iter().enumerate() {
        for &node in knot {
            knot_of[graph[node]] = at;
        }
    }
    let mut starts: Vec<usize> =
        knots.iter().filter_map(|knot| knot.iter().map(|&node| graph[node]).min()).collect();
    starts.sort_unstable();
    for start in starts {
        let path = shortest_cycle(draft, &knot_of, start);
        report(reader, draft, &path);
    }
}

/// The shortest way from `start` back to itself, each node reading the next, `start` once.
fn shortest_cycle(draft: &Draft<'_>, knot_of: &[usize], start: usize) -> Vec<usize> {
    let mut came_from = std::collections::HashMap::new();
    let mut queue = VecDeque::from([start]);
    'search: while let Some(node) = queue.pop_front() {
        for (source, _) in draft.reads(node) {
            if knot_of[source] == knot_of[start] && !came_from.contains_key(&source) {
                came_from.insert(source, node);
                if source == start {
                    break 'search;
                }
                queue.push_back(source);
            }
        }
    }
    let mut path = Vec::new();
    let mut node = start;
    while let Some(&before) = came_from.get(&node) {
        path.push(before);
        if before == start {
            break;
        }
        node = before;
    }
    path.reverse();
    path
}

fn report(reader: &mut Reader<'_>, draft: &Draft<'_>, path: &[usize]) {
    let Some(&start) = path.first() else { return };
    let arrow = |nodes: &[usize]| {
        let names: Vec<String> =
            nodes.iter().map(|&node| format!("`{}`", shortened(draft.name(node)))).collect();
        names.join(" → ")
    };
    let back = format!("`{}`", shortened(draft.name(start)));
    let shown = if path.len() <= MAX_CYCLE_SHOWN {
        format!("{} → {back}", arrow(path))
    } else {
        let (head, tail) = (MAX_CYCLE_SHOWN / 2, MAX_CYCLE_SHOWN / 2);
        let hidden = path.len() - head - tail;
        let last = &path[path.len() - tail..];
        format!("{} → ({hidden} more) → {} → {back}", arrow(&path[..head]), arrow(last))
    };
    let message = match path.len() {
        1 => format!("node {back} reads itself"),
        many => format!("{many} nodes read one another in a cycle: {shown}"),
    };
    let edge = |at: usize| {
        let (node, next) = (path[at], path[(at + 1) % path.len()]);
        draft.reads(node).find(|(source, _)| *source == next).map(|(_, input)| (node, next, input))
    };
    let Some((_, _, first)) = edge(0) else { return };
    let place = reader.document.place(first.source.value);
    let help = "break the cycle at one of its connections";
    let mut finding = Finding::new(Code::CYCLE, place, message, help);
    for at in 1..path.len().min(MAX_CYCLE_SHOWN) {
        if let Some((node, next, input)) = edge(at) {
            let (node, next) = (shortened(draft.name(node)), shortened(draft.name(next)));
            let message =
                format!("`{node}` reads `{next}` in its input `{}`", shortened(&input.member.key));
            finding = finding.with_related(reader.document.place(input.source.value), message);
        }
    }
    reader.findings.push(finding);
}
