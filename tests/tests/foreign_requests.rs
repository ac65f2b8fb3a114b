//! Nodes of another crate that ask the renderer: they declare what they want of the answer, in any
//! order, and neither read nor write anything else.

use std::sync::Arc;

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_tests::build::{Build, Built, color, every_engine};
use phenomenon_tests::differential::Case;
use phenomenon_tests::mock::MockRenderer;
use phenomenon_tests::random::Random;

/// A mirror that wants the colour alone.
mod colour_of_mirror {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::{NOT_NEGATIVE, node};

    node! {
        /// The colour a mirror shows.
        colour_of_mirror in rays request TraceReflection,
        source "test",
        inputs {
            /// Direction of the ray.
            direction: vector = node("reflection_direction");
        }
        outputs {
            /// Colour seen along the ray.
            color: color, in NOT_NEGATIVE;
        }
    }
}

/// A mirror that wants the end of the answer first, and no colour.
mod reach_of_mirror {
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::{NOT_NEGATIVE, node};

    node! {
        /// How far a mirror sees.
        reach_of_mirror in rays request TraceReflection,
        source "test",
        inputs {
            /// Direction of the ray.
            direction: vector = node("reflection_direction");
        }
        outputs {
            /// Distance to what is seen.
            distance: scalar, in NOT_NEGATIVE;
            /// Whether anything is.
            hit: boolean;
        }
    }
}

fn library() -> NodeLibrary {
    let mut library = NodeLibrary::standard();
    library.add(colour_of_mirror::definition());
    library.add(reach_of_mirror::definition());
    library
}

/// All engines and the naive evaluator agree on `built`.
fn agree(built: &Built) {
    let mut random = Random::new(5);
    let case = Case {
        graph: Arc::clone(&built.graph),
        values: Vec::new(),
        points: random.states(33),
        options: every_engine(),
        naive: true,
    };
    let agreement = case.check().unwrap_or_else(|error| panic!("{error}"));
    assert!(agreement.ran && agreement.naive && agreement.requests > 0);
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
