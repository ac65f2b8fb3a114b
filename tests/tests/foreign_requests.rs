//! Nodes of another crate that ask the renderer: they declare what they want of the answer, in any
//! order, and neither read nor write anything else.

use std::sync::Arc;

use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::build::{Build, Built, color};
use phenomenon_compiler::testing::mock::MockRenderer;
use phenomenon_foreign_nodes::library;

/// All engines and the naive evaluator agree on `built`, which asks.
fn agree(built: &Built) {
    assert!(built.agree(5).requests > 0);
}

#[test]
fn a_request_that_declares_one_output_overwrites_nothing() {
    let mut build = Build::with(library());
    let seen = build.node("colour_of_mirror", &[]);
    let state = build.node("state", &[]);
    // Its slots come right after those of the request, and in a batch they are filled before it.
    let own = build.node("combine_color", &[("r", state.output("u")), ("a", state.output("v"))]);
    let both = build.node("add", &[("a", seen.first()), ("b", own.first())]);
    let built = build.material(both.first());
    agree(&built);
}

#[test]
fn outputs_are_found_by_name_wherever_they_stand() {
    let shown = |node: &str| {
        let mut build = Build::with(library());
        let seen = build.node(node, &[]);
        let (distance, hit) = (seen.output("distance"), seen.output("hit"));
        let inputs = [("condition", hit), ("if_true", distance), ("if_false", color([0.5; 4]))];
        let chosen = build.node("select", &inputs);
        build.material(chosen.first())
    };
    let (foreign, standard) = (shown("reach_of_mirror"), shown("trace_reflection"));
    agree(&foreign);
    let points = [State::default(); 3];
    // Names of nodes are keys of random numbers, and the mock's answers depend on them.
    let mut graph = (*foreign.graph).clone();
    graph.nodes[0].name = standard.graph.nodes[0].name.clone();
    let foreign = Built { graph: Arc::new(graph) };
    let mut expected = Vec::new();
    let renderer = MockRenderer::default();
    standard
        .in_every_engine(&[], &points, &renderer, |_, _, results| expected.push(results.to_vec()));
    let mut found = Vec::new();
    foreign.in_every_engine(&[], &points, &renderer, |_, _, results| found.push(results.to_vec()));
    assert_eq!(found, expected);
}
