//! Maps and folds: a phenomenon called once for each value of a list.

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;

use super::files::{check_files, graph};
use super::shading::shaded;

/// Twice a color, and the number of the turn.
const TURN: &str = r#"{ "phenomenon": "turn",
    "interface": { "item": { "type": "color", "default": 0 }, "index": { "type": "integer", "default": 0 },
        "gain": { "type": "scalar", "default": 1 } },
    "nodes": {
        "scaled": { "type": "scale", "inputs": { "input": { "interface": "item" }, "factor": { "interface": "gain" } } },
        "counted": { "type": "add", "inputs": { "a": { "node": "scaled" }, "b": { "interface": "index" } } } },
    "roots": { "material": { "node": "counted" } } }"#;

/// What was before, taken ten times, and one digit more.
const DIGIT: &str = r#"{ "phenomenon": "digit",
    "interface": { "item": { "type": "scalar", "default": 0 }, "accumulated": { "type": "color", "default": 0 } },
    "nodes": {
        "before": { "type": "scale", "inputs": { "input": { "interface": "accumulated" }, "factor": 10 } },
        "one": { "type": "add", "inputs": { "a": { "node": "before" }, "b": { "interface": "item" } } } },
    "roots": { "material": { "node": "one" } } }"#;

/// Casts a ray, and weighs it.
const RAY: &str = r#"{ "phenomenon": "ray",
    "interface": { "item": { "type": "scalar", "default": 0 } },
    "nodes": { "mirror": { "type": "trace_reflection" },
        "weighed": { "type": "mix", "inputs": { "weight": { "interface": "item" }, "a": 0, "b": { "node": "mirror" } } } },
    "roots": { "material": { "node": "weighed" } } }"#;

/// A layer over those before, which it hides where it is opaque.
const LAYER: &str = r#"{ "phenomenon": "layer",
    "interface": {
        "item": { "type": "struct", "members": {
            "tint": { "type": "color", "default": [1, 0, 0] }, "cover": { "type": "scalar", "default": 1 } } },
        "accumulated": { "type": "color", "default": 0 } },
    "nodes": { "over": { "type": "mix", "inputs": { "weight": { "interface": "item.cover" },
        "a": { "interface": "accumulated" }, "b": { "interface": "item.tint" } } } },
    "roots": { "material": { "node": "over" } } }"#;

fn with(interface: &str, nodes: &str) -> String {
    format!(
        r#"{{ "phenomenon": "a", "interface": {{ {interface} }}, "nodes": {{ {nodes} }},
            "roots": {{ "material": {{ "node": "shade" }} }} }}"#
    )
}

fn made(text: &str) -> Graph {
    let bodies =
        [("turn.json", TURN), ("digit.json", DIGIT), ("ray.json", RAY), ("layer.json", LAYER)];
    graph(&[&[("a.json", text)], &bodies[..]].concat())
}

fn red(graph: &Graph, values: &[(&str, Literal)]) -> (f32, usize) {
    let (color, asked) = shaded(graph, RootKind::Material, values, State::default());
    (color[0], asked.rays)
}

#[test]
fn a_map_yields_a_list() {
    let graph = made(&with(
        r#""n": { "type": "integer", "default": 0 }, "gain": { "type": "scalar", "default": 2 }"#,
        r#""all": { "type": { "map": { "file": "turn.json" } },
               "inputs": { "over": [1, { "node": "seven" }, 3], "gain": { "interface": "gain" } } },
           "seven": { "type": "constant_scalar", "inputs": { "value": 7 } },
           "sum": { "type": "sum", "inputs": { "values": { "node": "all" } } },
           "one": { "type": "element", "inputs": { "index": { "interface": "n" }, "values": { "node": "all", "output": "color" } } },
           "shade": { "type": "add", "inputs": { "a": { "node": "sum" }, "b": { "node": "one" } } }"#,
    ));
    // 2, 14 + 1 and 6 + 2, which is 25.
    for (n, one) in [(0, 2.0), (1, 15.0), (2, 8.0), (9, 8.0)] {
        assert_eq!(red(&graph, &[("n", Literal::Integer(n))]).0, 25.0 + one, "{n}");
    }
    assert!(graph.nodes.iter().any(|node| node.name == "all[1]/scaled"));
}

#[test]
fn a_fold_hands_each_turn_what_the_one_before_yielded() {
    let graph = made(&with(
        r#""digits": { "type": "array", "of": { "type": "scalar" }, "default": [1, 2, 3] }"#,
        r#""shade": { "type": { "fold": { "file": "digit.json" } },
               "inputs": { "over": { "interface": "digits" }, "initial": 4 } }"#,
    ));
    assert_eq!(red(&graph, &[]).0, 4123.0);
    assert_eq!(red(&graph, &[("digits[1]", Literal::Scalar(9.0))]).0, 4193.0);
    let single = made(&with(
        "",
        r#""shade": { "type": { "fold": { "file": "digit.json" } }, "inputs": { "over": [5], "initial": 4 } }"#,
    ));
    assert_eq!(red(&single, &[]).0, 45.0);
}

#[test]
fn an_element_of_a_map_evaluates_that_turn_alone() {
    let graph = made(&with(
        r#""n": { "type": "integer", "default": 0 }"#,
        r#""rays": { "type": { "map": { "file": "ray.json" } }, "inputs": { "over": [0, 0.5, 1, 0.5] } },
           "shade": { "type": "element", "inputs": { "index": { "interface": "n" }, "values": { "node": "rays" } } }"#,
    ));
    for (n, rays) in [(0, 0), (1, 1), (2, 1), (3, 1)] {
        assert_eq!(red(&graph, &[("n", Literal::Integer(n))]).1, rays, "{n}");
    }
}

#[test]
fn structs_are_handed_to_turns() {
    let graph = made(&with(
        r#""layers": { "type": "array", "of": { "type": "struct", "members": {
               "cover": { "type": "scalar", "default": 1 }, "tint": { "type": "color", "default": [1, 0, 0] } } },
               "default": [{ "struct": { "tint": 4 } }, { "struct": { "cover": 0.5, "tint": 8 } }] }"#,
        r#""ray": { "type": "trace_reflection" },
           "shade": { "type": { "fold": { "file": "layer.json" } },
               "inputs": { "over": { "interface": "layers" }, "initial": { "node": "ray" } } }"#,
    ));
    assert_eq!(red(&graph, &[]), (6.0, 0), "the first layer hides what was before");
    assert_eq!(red(&graph, &[("layers[0].cover", Literal::Scalar(0.0))]).1, 1);
    let written = made(&with(
        "",
        r#""shade": { "type": { "fold": { "file": "layer.json" } }, "inputs": { "initial": 0,
               "over": [{ "struct": { "tint": 2 } }, { "struct": { "cover": 0.25, "tint": 6 } }] } }"#,
    ));
    assert_eq!(red(&written, &[]).0, 3.0);
}

#[test]
fn maps_go_over_maps_in_any_order() {
    let graph = made(&with(
        "",
        r#""shade": { "type": "switch", "inputs": { "index": 1, "cases": { "node": "again" } } },
           "again": { "type": { "map": { "file": "turn.json" } }, "inputs": { "over": { "node": "once" }, "gain": 10 } },
           "once": { "type": { "map": { "file": "turn.json" } }, "inputs": { "over": [1, 2, 3] } }"#,
    ));
    assert_eq!(red(&graph, &[]).0, 31.0);
}

#[test]
fn a_root_calls_the_turns_of_a_map_in_turn() {
    let text = r#"{ "phenomenon": "a", "nodes": {
            "all": { "type": { "map": { "file": "turn.json" } }, "inputs": { "over": [1, 2] } } },
        "roots": { "material": { "node": "all" } } }"#;
    assert_eq!(red(&made(text), &[]).0, 3.0, "the last replaces the color of the first");
}

#[test]
fn mistakes_of_all_turns_are_told_once() {
    let of = |nodes: &str| {
        let files = [("a.json", &*with("", nodes)), ("turn.json", TURN), ("digit.json", DIGIT)];
        let findings = check_files(&files).findings;
        let told = findings.iter().map(|it| (it.code, it.place.start, it.message.clone()));
        told.collect::<Vec<_>>()
    };
    let twice = of(
        r#""all": { "type": { "map": { "file": "turn.json" } }, "inputs": { "over": [1, 2, 3], "gian": 3 } },
           "shade": { "type": "sum", "inputs": { "values": { "node": "all" } } }"#,
    );
    assert_eq!(twice.len(), 1, "{twice:?}");
    assert_eq!(twice[0].0, Code::UNKNOWN_INPUT);
    let second = of(
        r#""all": { "type": { "map": { "file": "turn.json" } }, "inputs": { "over": [1, [1, 2], true] } },
           "shade": { "type": "sum", "inputs": { "values": { "node": "all" } } }"#,
    );
    // Turns are called as the map is: which of them it is, the place tells.
    assert_eq!(second.len(), 2, "{second:?}");
    assert!(second.iter().all(|told| told.2.contains("of node `all`")), "{second:?}");
    assert!(second[0].1 < second[1].1, "{second:?}");
}
