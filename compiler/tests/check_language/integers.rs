//! Integers that are computed, and what they choose.

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::{Literal, Type};

use super::files::{check, codes, graph};
use super::shading::shaded;

/// A graph whose material is the node `shade`, and which may take an integer `n`.
fn with(nodes: &str) -> String {
    format!(
        r#"{{ "phenomenon": "a", "interface": {{ "n": {{ "type": "integer", "default": 0 }} }},
            "nodes": {{ {nodes} }}, "roots": {{ "material": {{ "node": "shade" }} }} }}"#
    )
}

fn made(nodes: &str) -> Graph {
    graph(&[("a.json", &with(nodes))])
}

/// What a graph yields in red for values of `n`, and how many rays it cast for all of them.
fn over(graph: &Graph, values: &[i32]) -> (Vec<f32>, usize) {
    let mut rays = 0;
    let of = values.iter().map(|&n| {
        let given = [("n", Literal::Integer(n))];
        let (color, asked) = shaded(graph, RootKind::Material, &given, State::default());
        rays += asked.rays;
        color[0]
    });
    (of.collect(), rays)
}

/// The type that a node's generic inputs have.
fn generic(graph: &Graph, name: &str) -> Option<Type> {
    let node = graph.nodes.iter().find(|node| node.name == name).expect("the node");
    graph.library.definition(node.node_type).overloads[node.overload].generic
}

#[test]
fn a_switch_of_any_length_evaluates_one_case() {
    let graph = made(
        r#""a": { "type": "trace_reflection" }, "b": { "type": "trace_reflection" },
           "shade": { "type": "switch", "inputs": { "index": { "interface": "n" },
               "cases": [0, 1, { "node": "a" }, 3, { "node": "b" }, 5, 6] } }"#,
    );
    let (values, rays) = over(&graph, &[i32::MIN, -1, 0, 1, 3, 5, 6, 7, i32::MAX]);
    assert_eq!(values, [0.0, 0.0, 0.0, 1.0, 3.0, 5.0, 6.0, 6.0, 6.0]);
    assert_eq!(rays, 0);
    assert_eq!(over(&graph, &[2, 4]).1, 2);
    // Four cases by name are what they were: one node.
    let four = made(
        r#""shade": { "type": "switch", "inputs": { "index": { "interface": "n" }, "case_0": 4, "case_3": 7 } }"#,
    );
    assert_eq!(over(&four, &[-1, 0, 1, 3, 9]).0, [4.0, 4.0, 0.0, 7.0, 7.0]);
    assert_eq!(four.nodes.len(), 1);
}

#[test]
fn what_is_computed_chooses() {
    let graph = made(
        r#""next": { "type": "integer_add", "inputs": { "a": { "interface": "n" }, "b": 1 } },
           "turn": { "type": "integer_modulo", "inputs": { "a": { "node": "next" }, "b": 3 } },
           "one": { "type": "element", "inputs": { "index": { "node": "turn" }, "values": [10, 20, 30] } },
           "other": { "type": "switch", "inputs": { "index": { "node": "turn" }, "case_0": 1, "case_1": 2, "case_2": 3 } },
           "shade": { "type": "add", "inputs": { "a": { "node": "one" }, "b": { "node": "other" } } }"#,
    );
    assert_eq!(over(&graph, &[-1, 0, 1, 2, i32::MAX]).0, [11.0, 22.0, 33.0, 11.0, 22.0]);
}

#[test]
fn integers_are_compared_as_integers() {
    let graph = made(
        r#""is": { "type": "equal", "inputs": { "a": { "interface": "n" }, "b": 16777217 } },
           "shade": { "type": "select", "inputs": { "condition": { "node": "is" } } }"#,
    );
    assert_eq!(over(&graph, &[16_777_216, 16_777_217, 16_777_218]).0, [0.0, 1.0, 0.0]);
    assert_eq!(generic(&graph, "is"), Some(Type::Integer));
    // With a scalar beside it an integer is a scalar, and -0 is one.
    for b in ["16777217.5", "-0", "1e10"] {
        let graph = made(&format!(
            r#""is": {{ "type": "less", "inputs": {{ "a": {{ "interface": "n" }}, "b": {b} }} }},
               "shade": {{ "type": "select", "inputs": {{ "condition": {{ "node": "is" }} }} }}"#
        ));
        assert_eq!(generic(&graph, "is"), Some(Type::Scalar), "{b}");
    }
}

#[test]
fn select_takes_what_nodes_compute() {
    let graph = made(
        r#""odd": { "type": "integer_modulo", "inputs": { "a": { "interface": "n" }, "b": 2 } },
           "is_odd": { "type": "equal", "inputs": { "a": { "node": "odd" }, "b": 1 } },
           "number": { "type": "select", "inputs": { "condition": { "node": "is_odd" },
               "if_true": { "interface": "n" }, "if_false": 7 } },
           "truth": { "type": "select", "inputs": { "condition": { "node": "is_odd" },
               "if_true": { "node": "is_odd" }, "if_false": true } },
           "map": { "type": "select", "inputs": { "condition": { "node": "truth" },
               "if_true": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1] } },
           "moved": { "type": "transform_vector", "inputs": { "transform": { "node": "map" }, "vector": [1, 0, 0] } },
           "split": { "type": "split_vector", "inputs": { "vector": { "node": "moved" } } },
           "shade": { "type": "add", "inputs": { "a": { "node": "number" }, "b": { "node": "split", "output": "x" } } }"#,
    );
    assert_eq!(over(&graph, &[0, 1, 2, 3]).0, [9.0, 3.0, 9.0, 5.0]);
    for (node, of) in
        [("number", Type::Integer), ("truth", Type::Boolean), ("map", Type::Transform)]
    {
        assert_eq!(generic(&graph, node), Some(of), "{node}");
    }
}

#[test]
fn lists_hold_what_nodes_compute() {
    let graph = made(
        r#""which": { "type": "element", "inputs": { "index": { "interface": "n" },
               "values": [{ "interface": "n" }, 2, 1] } },
           "truth": { "type": "element", "inputs": { "index": { "node": "which" }, "values": [true, false, true] } },
           "shade": { "type": "select", "inputs": { "condition": { "node": "truth" } } }"#,
    );
    assert_eq!(generic(&graph, "which"), Some(Type::Integer));
    assert_eq!(over(&graph, &[0, 1, 2]).0, [1.0, 1.0, 0.0]);
}

#[test]
fn what_is_known_before_shading_is_not_chosen() {
    let nodes = r#""name": { "type": "select", "inputs": { "condition": true, "if_true": { "interface": "s" } } },
        "shade": { "type": "add", "inputs": { "a": { "node": "name" } } }"#;
    let text = format!(
        r#"{{ "phenomenon": "a", "interface": {{ "s": {{ "type": "lights" }} }},
            "nodes": {{ {nodes} }}, "roots": {{ "material": {{ "node": "shade" }} }} }}"#
    );
    let findings = check(&text).findings;
    assert_eq!(codes(&text), [Code::TYPE_MISMATCH]);
    assert!(findings[0].help.contains("known before shading"), "{}", findings[0].help);
}
