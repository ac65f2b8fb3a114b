//! The order of evaluation, and cycles, wherever they are.

use std::collections::VecDeque;

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::Reader;

use super::draft::{Draft, DraftInput};
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

/// A node of a cycle as the file has it: what it is called there, and which of its inputs reads the next.
struct Step<'r, 'd> {
    name: String,
    input: &'r DraftInput<'d>,
}

/// The steps of a cycle, none of them a node that the file does not have: an expression is where an input reads what the
/// expression names, and the turns of a map or a fold are it.
fn steps<'r, 'd>(draft: &'r Draft<'d>, path: &[usize]) -> Vec<Step<'r, 'd>> {
    let next = |at: usize| path[(at + 1) % path.len()];
    let of_file = (0..path.len()).filter(|&at| !draft.is_written(draft.name(path[at])));
    let steps = of_file.filter_map(|at| {
        let (_, input) = draft.reads(path[at]).find(|(source, _)| *source == next(at))?;
        Some(Step { name: draft.told_name(path[at]), input })
    });
    let mut steps: Vec<Step<'_, '_>> = steps.collect();
    // From turn to turn of one fold is no step.
    steps.dedup_by(|later, earlier| {
        let same = later.name == earlier.name;
        if same {
            earlier.input = later.input;
        }
        same
    });
    if steps.len() > 1 && steps.first().map(|it| &it.name) == steps.last().map(|it| &it.name) {
        steps.pop();
    }
    steps
}

fn report(reader: &mut Reader<'_>, draft: &Draft<'_>, path: &[usize]) {
    let steps = steps(draft, path);
    let Some(first) = steps.first() else { return };
    let arrow = |steps: &[Step<'_, '_>]| {
        let names: Vec<String> = steps.iter().map(|step| format!("`{}`", step.name)).collect();
        names.join(" → ")
    };
    let back = format!("`{}`", first.name);
    let shown = if steps.len() <= MAX_CYCLE_SHOWN {
        format!("{} → {back}", arrow(&steps))
    } else {
        let (head, tail) = (MAX_CYCLE_SHOWN / 2, MAX_CYCLE_SHOWN / 2);
        let hidden = steps.len() - head - tail;
        let last = &steps[steps.len() - tail..];
        format!("{} → ({hidden} more) → {} → {back}", arrow(&steps[..head]), arrow(last))
    };
    let message = match steps.len() {
        1 => format!("node {back} reads itself"),
        many => format!("{many} nodes read one another in a cycle: {shown}"),
    };
    let place = reader.document.place(first.input.source.value);
    let help = "break the cycle at one of its connections";
    let mut finding = Finding::new(Code::CYCLE, place, message, help);
    for at in 1..steps.len().min(MAX_CYCLE_SHOWN) {
        let (step, next) = (&steps[at], &steps[(at + 1) % steps.len()]);
        let key = shortened(&step.input.member.key);
        let message = format!("`{}` reads `{}` in its input `{key}`", step.name, next.name);
        finding = finding.with_related(reader.document.place(step.input.source.value), message);
    }
    reader.findings.push(finding);
}
