//! Expressions within phenomena of a file, in outputs, and in what maps and folds are given.

use std::sync::Arc;

use phenomenon_compiler::testing::build::every_engine;
use phenomenon_compiler::testing::mock::MockRenderer;

use crate::build::{graph, shaded};

/// Checks that a graph yields one number in every engine.
fn yields(text: &str, expected: f32) {
    let graph = Arc::new(graph(text));
    for options in every_engine() {
        let color = shaded(&graph, options, &mut MockRenderer::default());
        let expected = [expected, expected, expected, 1.0];
        assert_eq!(color.map(f32::to_bits), expected.map(f32::to_bits), "{options:?} {text}");
    }
}

#[test]
fn phenomena_within_a_file_and_outputs_have_expressions_too() {
    let text = r##"{
        "phenomenon": "outer",
        "phenomena": { "line": {
            "interface": { "x": { "type": "scalar", "default": 1 }, "tint": { "type": "color", "default": { "srgb": "#fff" } } },
            "nodes": { "twice": { "type": "multiply", "inputs": { "a": { "expression": "x + 1" }, "b": 2 } } },
            "outputs": {
                "y": { "type": "scalar", "from": { "expression": "twice - tint.g * half", "where": { "half": 0.5 } } },
                "c": { "type": "color", "from": { "expression": "tint * up", "where": { "up": { "interface": "tint.r" } } } }
            } } },
        "nodes": { "one": { "type": { "phenomenon": "line" }, "inputs": { "x": { "expression": "0.25 + 0.5" } } } },
        "roots": { "material": { "expression": "one.y + one.c.r" } } }"##;
    let graph = Arc::new(graph(text));
    assert_eq!(graph.expressions.len(), 5);
    assert!(graph.nodes.iter().any(|node| node.name == "one/twice@a"), "{:?}", graph.nodes);
    for options in every_engine() {
        let color = shaded(&graph, options, &mut MockRenderer::default());
        assert_eq!(color.map(f32::to_bits), [4.0, 4.0, 4.0, 1.0].map(f32::to_bits), "{options:?}");
    }
}

/// The bodies of a map and of a fold, in expressions.
const TURNS: &str = r#""phenomena": {
    "turn": { "interface": { "item": { "type": "scalar", "default": 0 }, "k": { "type": "scalar", "default": 9 },
            "index": { "type": "integer", "default": 0 } },
        "outputs": { "y": { "type": "scalar", "from": { "expression": "item * k + index" } },
            "pair": { "type": "vector", "from": { "expression": "vector(item, k, 0)" } } } },
    "laid": { "interface": { "item": { "type": "scalar", "default": 0 }, "accumulated": { "type": "scalar", "default": 0 },
            "by": { "type": "scalar", "default": 9 } },
        "outputs": { "y": { "type": "scalar", "from": { "expression": "item + accumulated * by" } } } } }"#;

#[test]
fn turns_are_given_expressions() {
    // Written once, and given to every turn: 2 * k + 0, 3 * k + 1, 4 * k + 2 with k = 2 * half.
    let map = |root: &str, inputs: &str| {
        format!(
            r#"{{ "phenomenon": "m", "interface": {{ "half": {{ "type": "scalar", "default": 0.5 }} }}, {TURNS},
                "nodes": {{ "all": {{ "type": {{ "map": {{ "phenomenon": "turn" }} }}, "inputs": {{ {inputs} }} }},
                    "sum": {{ "type": "sum", "inputs": {{ "values": {{ "node": "all" }} }} }} }},
                "roots": {{ "material": {{ "expression": "{root}" }} }} }}"#
        )
    };
    let inputs = r#""over": [2, 3, { "expression": "8 * half" }], "k": { "expression": "once + once", "where": { "once": { "interface": "half" } } }"#;
    yields(&map("sum", inputs), 2.0 + 4.0 + 6.0);
    // A turn is named by its number, and has the outputs of the body.
    yields(&map("all[2] - all[0] + all[1].pair.x + 0 * sum", inputs), 6.0 - 2.0 + 3.0);
    let fold = format!(
        r#"{{ "phenomenon": "f", "interface": {{ "half": {{ "type": "scalar", "default": 0.5 }} }}, {TURNS},
            "nodes": {{ "all": {{ "type": {{ "fold": {{ "phenomenon": "laid" }} }}, "inputs": {{
                "over": [{{ "expression": "half" }}, 1, {{ "expression": "half * 6" }}],
                "initial": {{ "expression": "half + 1" }}, "by": {{ "expression": "half * 4" }} }} }} }},
            "roots": {{ "material": {{ "expression": "all" }} }} }}"#
    );
    yields(&fold, 3.0 + 2.0 * (1.0 + 2.0 * (0.5 + 2.0 * 1.5)));
}

#[test]
fn names_are_those_of_the_phenomenon_round_the_text() {
    // `t` is another thing in each: a parameter without, a node within, a name under `where` in the last.
    let text = r#"{ "phenomenon": "outer", "interface": { "t": { "type": "scalar", "default": 2 },
            "look": { "type": "struct", "members": { "t": { "type": "scalar", "default": 3 },
                "list": { "type": "array", "of": { "type": "scalar" }, "default": [5, 7] } } } },
        "phenomena": { "middle": { "interface": { "a": { "type": "scalar", "default": 1 } },
            "phenomena": { "inmost": { "interface": { "t": { "type": "scalar", "default": 11 } },
                "outputs": { "y": { "type": "scalar", "from": { "expression": "t * t", "where": { "t": { "expression": "t + 1" } } } } } } },
            "nodes": { "t": { "type": { "phenomenon": "inmost" }, "inputs": { "t": { "expression": "a * 2" } } } },
            "outputs": { "y": { "type": "scalar", "from": { "expression": "t + t.y" } },
                "v": { "type": "vector", "from": { "expression": "vector(a, t, 0).yxz" } } } } },
        "nodes": {
            "m": { "type": { "phenomenon": "middle" }, "inputs": { "a": { "expression": "t", "where": { "t": { "interface": "look.t" } } } } },
            "s": { "type": "sum", "inputs": { "values": [{ "expression": "look.list[1]" }, { "expression": "t" }, 1,
                { "expression": "u", "where": { "v": { "expression": "t * 10" }, "u": { "expression": "v + w",
                    "where": { "w": { "expression": "v * 2" }, "v": 0.5 } } } }] } } },
        "roots": { "material": { "color": { "expression": "m.v.x + m + s" }, "ok": { "expression": "(m > 0) == (t != 0)" } } } }"#;
    // inmost: (6 + 1)^2 = 49; m = 98, m.v.x = 49; s = 7 + 2 + 1 + (0.5 + 40)
    yields(text, 49.0 + 98.0 + 50.5);
}

#[test]
fn booleans_are_compared_and_integers_keep_their_digits() {
    let graph = |expression: &str| {
        format!(
            r#"{{ "phenomenon": "b", "interface": {{ "on": {{ "type": "boolean", "default": true }},
                "n": {{ "type": "integer", "default": 16777217 }}, "m": {{ "type": "integer", "default": 16777216 }} }},
                "roots": {{ "material": {{ "expression": "{expression} ? 1 : 0" }} }} }}"#
        )
    };
    for (expression, holds) in [
        ("on == true", 1.0),
        ("on != (n > m)", 0.0),
        ("on == (n <= m)", 0.0),
        ("n != m and n > m and n >= m", 1.0),
        ("not_equal(n, m) and greater(n, m) and not greater_equal(m, n)", 1.0),
        ("between(input: n, low: n, high: n) and not between(input: m, low: n, high: n)", 1.0),
    ] {
        yields(&graph(expression), holds);
    }
}
