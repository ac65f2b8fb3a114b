//! Makes a failing case small: fewer points, fewer engines, then connections cut one by one while it
//! still fails.

use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::graph::{Binding, Graph, Root};
use crate::nodes::DefaultValue;
use crate::values::{Literal, Type};

use super::differential::Case;
use super::random_graph::is_of_turn;
use super::reads::{self, Fields};

/// How long to go on shrinking.
const PATIENCE: Duration = Duration::from_secs(20);

/// A smaller case that fails too, with its error.
pub fn shrink(case: &Case, error: String) -> (Case, String) {
    let start = Instant::now();
    let (mut case, mut error) = (case.clone(), error);
    loop {
        let smaller = candidates(&case).find_map(|candidate| {
            if start.elapsed() > PATIENCE {
                return None;
            }
            candidate.check().err().map(|error| (candidate, error))
        });
        match smaller {
            Some(found) => (case, error) = found,
            None => return (case, error),
        }
    }
}

fn candidates(case: &Case) -> impl Iterator<Item = Case> {
    let mut candidates = Vec::new();
    if case.points.len() > 1 {
        let points = case.points.chunks(case.points.len().div_ceil(2));
        candidates.extend(points.map(|half| Case { points: half.to_vec(), ..case.clone() }));
    }
    if case.options.len() + usize::from(case.naive) > 1 {
        for option in &case.options {
            candidates.push(Case { options: vec![*option], naive: false, ..case.clone() });
        }
        candidates.push(Case { options: Vec::new(), naive: true, ..case.clone() });
    }
    let graphs = smaller_graphs(&case.graph).into_iter();
    candidates.extend(graphs.map(|graph| Case { graph: Arc::new(graph), ..case.clone() }));
    candidates.into_iter()
}

fn smaller_graphs(graph: &Graph) -> Vec<Graph> {
    let mut smaller = with_smaller_roots(graph);
    for (node, of) in graph.nodes.iter().enumerate() {
        for (input, binding) in of.inputs.iter().enumerate() {
            let declared = &graph.library.signature(of.node_type).inputs[input];
            let plain = match declared.default {
                DefaultValue::Required => Binding::Literal(Literal::Vector([0.0, 0.0, 1.0])),
                _ => Binding::Default,
            };
            let mut instead = shortcuts(graph, binding);
            if *binding != plain {
                instead.push(plain);
            }
            smaller.extend(instead.into_iter().map(|binding| {
                let mut graph = graph.clone();
                graph.nodes[node].inputs[input] = binding;
                graph
            }));
        }
    }
    let smaller = smaller.into_iter().map(without_unused);
    smaller.filter(is_valid).collect()
}

fn with_smaller_roots(graph: &Graph) -> Vec<Graph> {
    let mut smaller = Vec::new();
    let with = |roots: Vec<Root>| Graph { roots, ..graph.clone() };
    if graph.roots.len() > 1 {
        smaller.extend(graph.roots.iter().map(|root| with(vec![root.clone()])));
    }
    for (at, root) in graph.roots.iter().enumerate() {
        let mut replace = |root: Root| {
            let mut roots = graph.roots.clone();
            roots[at] = root;
            smaller.push(with(roots));
        };
        if root.ok != Binding::Default {
            replace(Root { ok: Binding::Default, ..root.clone() });
        }
        // What feeds the root's colour may fail by itself.
        if let Binding::Node { node, .. } = root.color {
            let below = graph.nodes[node].inputs.iter();
            for color in below.filter_map(|binding| as_color(graph, binding)) {
                replace(Root { color, ..root.clone() });
            }
        }
    }
    smaller
}

/// Outputs of the same type that feed the node of a binding, so that it can be skipped.
fn shortcuts(graph: &Graph, binding: &Binding) -> Vec<Binding> {
    let Binding::Node { node, output } = binding else { return Vec::new() };
    let from = graph.output_type(*node, *output);
    let fits = |through: &&Binding| match through {
        Binding::Node { node, output } => graph.output_type(*node, *output) == from,
        _ => false,
    };
    graph.nodes[*node].inputs.iter().filter(fits).cloned().collect()
}

fn as_color(graph: &Graph, binding: &Binding) -> Option<Binding> {
    let Binding::Node { node, output } = binding else { return None };
    graph.output_type(*node, *output).converts_to(Type::Color).then(|| binding.clone())
}

/// Nodes no root needs are dropped.
fn without_unused(mut graph: Graph) -> Graph {
    let node_of = |binding: &Binding| match binding {
        Binding::Node { node, .. } => Some(*node),
        _ => None,
    };
    let mut used = vec![false; graph.nodes.len()];
    let roots = graph.roots.iter().flat_map(|root| [&root.color, &root.ok]);
    let mut rest: Vec<usize> = roots.filter_map(node_of).collect();
    while let Some(node) = rest.pop() {
        if !std::mem::replace(&mut used[node], true) {
            rest.extend(graph.nodes[node].inputs.iter().filter_map(node_of));
        }
    }
    let place: Vec<usize> = used
        .iter()
        .scan(0, |next, &used| {
            *next += usize::from(used);
            Some(next.wrapping_sub(1))
        })
        .collect();
    let moved = |binding: &mut Binding| {
        if let Binding::Node { node, .. } = binding {
            *node = place[*node];
        }
    };
    let mut keep = used.iter();
    graph.nodes.retain(|_| *keep.next().unwrap_or(&false));
    graph.nodes.iter_mut().flat_map(|node| &mut node.inputs).for_each(moved);
    for root in &mut graph.roots {
        moved(&mut root.color);
        moved(&mut root.ok);
    }
    graph
}

/// Whether turns of loops are read below loops only.
fn is_valid(graph: &Graph) -> bool {
    let mut known: Vec<Option<Fields>> = vec![None; graph.nodes.len()];
    let mut settled = true;
    while std::mem::take(&mut settled) {
        for at in 0..graph.nodes.len() {
            let node = &graph.nodes[at];
            let ready = known[at].is_none()
                && node.inputs.iter().all(|binding| {
                    !matches!(binding, Binding::Node { node, .. } if known[*node].is_none())
                });
            if ready {
                let of_output = |source: usize, output: usize| {
                    let whole = known[source].clone().unwrap_or_default();
                    reads::of_output(&graph.library, &graph.nodes[source], output, &whole)
                };
                let fields = reads::of_node(&graph.library, node, &of_output);
                known[at] = Some(fields);
                settled = true;
            }
        }
    }
    let reads_turn = |binding: &Binding| match binding {
        Binding::Node { node, output } => known[*node].as_ref().is_some_and(|whole| {
            is_of_turn(&reads::of_output(&graph.library, &graph.nodes[*node], *output, whole))
        }),
        _ => false,
    };
    !graph.roots.iter().any(|root| reads_turn(&root.color) || reads_turn(&root.ok))
}
