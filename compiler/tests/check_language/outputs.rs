//! Outputs of phenomena, and phenomena that stand in a file.

use phenomenon_compiler::check::MAX_FILE_DEPTH;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::{Literal, Type};

use super::files::{check, check_files, codes, graph};
use super::shading::{color, shaded};

/// Offers one output that traces, and others that do not.
const BODY: &str = r#"
    "interface": { "tint": { "type": "color", "default": [1, 0.5, 0.25] },
                   "height": { "type": "scalar", "default": 2 } },
    "nodes": {
        "here": { "type": "state" },
        "mirror": { "type": "trace_reflection" },
        "seen": { "type": "multiply", "inputs": { "a": { "node": "mirror" }, "b": { "interface": "tint" } } },
        "up": { "type": "scale", "inputs": { "input": { "node": "here", "output": "normal" },
                                             "factor": { "interface": "height" } } }
    },
    "outputs": {
        "seen": { "type": "color", "from": { "node": "seen" }, "doc": "What is mirrored" },
        "normal": { "type": "vector", "from": { "node": "up" } },
        "height": { "type": "scalar", "from": { "interface": "height" } },
        "high": { "type": "boolean", "from": true },
        "grey": { "type": "color", "from": { "interface": "height" } }
    }"#;

/// Reads one output of the phenomenon whose type is written so.
fn user(node_type: &str, output: &str, more: &str) -> String {
    format!(
        r#"{{ "phenomenon": "user", {more}
            "nodes": {{ "used": {{ "type": {node_type}, "inputs": {{ "height": 4 }} }} }},
            "roots": {{ "material": {{ "node": "used", "output": "{output}" }} }} }}"#
    )
}

fn in_file(output: &str) -> phenomenon_compiler::graph::Graph {
    let body = format!(r#"{{ "phenomenon": "p", {BODY} }}"#);
    graph(&[("a.json", &user(r#"{ "file": "p.json" }"#, output, "")), ("p.json", &body)])
}

fn inline(output: &str) -> phenomenon_compiler::graph::Graph {
    let phenomena = format!(r#""phenomena": {{ "p": {{ {BODY} }} }},"#);
    graph(&[("a.json", &user(r#"{ "phenomenon": "p" }"#, output, &phenomena))])
}

#[test]
fn every_output_has_its_value_and_only_what_is_read_is_evaluated() {
    for (output, expected, rays) in [
        ("seen", [1.0, 0.5, 0.25, 1.0], 1),
        ("normal.z", [4.0, 4.0, 4.0, 1.0], 0),
        ("height", [4.0, 4.0, 4.0, 1.0], 0),
        ("grey", [4.0, 4.0, 4.0, 1.0], 0),
        ("grey.a", [1.0, 1.0, 1.0, 1.0], 0),
    ] {
        for graph in [in_file(output), inline(output)] {
            let state = State { normal: [0.0, 0.0, 1.0], ..State::default() };
            let (color, asked) = shaded(&graph, RootKind::Material, &[], state);
            assert_eq!(color, expected, "{output}");
            assert_eq!(asked.rays, rays, "{output}");
        }
    }
}

#[test]
fn a_phenomenon_in_the_file_is_what_one_in_another_file_is() {
    let (other, own) = (in_file("seen"), inline("seen"));
    let names = |graph: &phenomenon_compiler::graph::Graph| -> Vec<String> {
        graph.nodes.iter().map(|node| node.name.clone()).collect()
    };
    assert_eq!(names(&own), ["used/here", "used/mirror", "used/seen", "used/up"]);
    assert_eq!(names(&own), names(&other));
    assert_eq!(format!("{:?}", own.nodes), format!("{:?}", other.nodes));
    assert_eq!(own.roots[0].color, other.roots[0].color);
}

#[test]
fn a_file_may_have_outputs_alone_and_keeps_them() {
    let graph = graph(&[("a.json", &format!(r#"{{ "phenomenon": "p", {BODY} }}"#))]);
    assert!(graph.roots.is_empty());
    let told: Vec<(&str, Type)> =
        graph.outputs.iter().map(|it| (it.name.as_str(), it.value_type)).collect();
    assert_eq!(told[0], ("seen", Type::Color));
    assert_eq!(told[3], ("high", Type::Boolean));
    assert_eq!(graph.outputs[3].value, Binding::Literal(Literal::Boolean(true)));
    assert_eq!(graph.outputs[0].doc, "What is mirrored");
    let shown = graph.with_output(2).unwrap();
    assert_eq!(color(&shown, &[("height", Literal::Scalar(0.5))]), [0.5, 0.5, 0.5, 1.0]);
    assert_eq!(color(&graph.with_output(3).unwrap(), &[]), [1.0; 4]);
}

#[test]
fn outputs_stand_beside_the_value_of_the_root() {
    let body = |outputs: &str| {
        format!(
            r#"{{ "phenomenon": "p", {outputs} "roots": {{ "material": {{ "color": [0.25, 0, 0], "ok": false }} }} }}"#
        )
    };
    let read = |outputs: &str, connection: &str| {
        let user = format!(
            r#"{{ "phenomenon": "u", "nodes": {{ "n": {{ "type": {{ "file": "p.json" }} }},
                  "one": {{ "type": "select", "inputs": {{ "condition": {{ "node": "n", "output": "ok" }},
                           "if_true": {connection}, "if_false": {connection} }} }} }},
               "roots": {{ "material": {{ "node": "one" }} }} }}"#
        );
        color(&graph(&[("a.json", &user), ("p.json", &body(outputs))]), &[])
    };
    let blue = r#""outputs": { "glow": { "type": "color", "from": [0, 0, 1] } },"#;
    assert_eq!(read("", r#"{ "node": "n" }"#), [0.25, 0.0, 0.0, 1.0]);
    assert_eq!(read(blue, r#"{ "node": "n" }"#), [0.25, 0.0, 0.0, 1.0], "the root comes first");
    assert_eq!(read(blue, r#"{ "node": "n", "output": "glow" }"#), [0.0, 0.0, 1.0, 1.0]);
    let own = r#""outputs": { "color": { "type": "color", "from": [0, 1, 0] } },"#;
    assert_eq!(read(own, r#"{ "node": "n", "output": "color" }"#), [0.0, 1.0, 0.0, 1.0]);
}

#[test]
fn what_no_output_that_is_read_rests_on_is_dead_and_asks_for_nothing() {
    let text = |output: &str| {
        format!(
            r#"{{ "phenomenon": "u",
                "phenomena": {{ "pair": {{
                    "interface": {{ "a": {{ "type": "scalar", "default": 0 }}, "b": {{ "type": "scalar", "default": 0 }} }},
                    "outputs": {{ "first": {{ "type": "scalar", "from": {{ "interface": "a" }} }},
                                  "second": {{ "type": "scalar", "from": {{ "interface": "b" }} }} }} }} }},
                "nodes": {{ "mirror": {{ "type": "trace_reflection" }},
                            "both": {{ "type": {{ "phenomenon": "pair" }},
                                       "inputs": {{ "a": 1, "b": {{ "node": "mirror", "output": "color.r" }} }} }} }},
                "roots": {{ "displacement": {{ "node": "both", "output": "{output}" }} }} }}"#
        )
    };
    assert_eq!(
        codes(&text("first")),
        [Code::UNREACHABLE_NODE],
        "nothing traces for a displacement"
    );
    assert_eq!(codes(&text("second")), [Code::MISPLACED_EFFECT]);
}

#[test]
fn names_are_looked_for_from_the_inside_out() {
    let value =
        |x: f32| format!(r#"{{ "outputs": {{ "x": {{ "type": "scalar", "from": {x} }} }} }}"#);
    let user = |more: &str, name: &str| {
        format!(
            r#"{{ {more} "nodes": {{ "n": {{ "type": {{ "phenomenon": "{name}" }} }} }},
                 "outputs": {{ "x": {{ "type": "scalar", "from": {{ "node": "n", "output": "x" }} }} }} }}"#
        )
    };
    let own = user(&format!(r#""phenomena": {{ "one": {} }},"#, value(4.0)), "one");
    let text = format!(
        r#"{{ "phenomenon": "u",
             "phenomena": {{ "one": {}, "beside": {}, "within": {own} }},
             "nodes": {{ "a": {{ "type": {{ "phenomenon": "beside" }} }},
                         "b": {{ "type": {{ "phenomenon": "within" }} }},
                         "sum": {{ "type": "add", "inputs": {{ "a": {{ "node": "a" }}, "b": {{ "node": "b" }} }} }} }},
             "roots": {{ "material": {{ "node": "sum" }} }} }}"#,
        value(1.0),
        user("", "one"),
    );
    let graph = graph(&[("a.json", &text)]);
    assert_eq!(graph.nodes.len(), 1);
    assert_eq!(color(&graph, &[])[0], 5.0);
}

#[test]
fn phenomena_of_a_file_use_files_too() {
    let text = r#"{ "phenomenon": "u",
        "phenomena": { "p": { "nodes": { "n": { "type": { "file": "grey.json" } } },
                              "outputs": { "x": { "type": "color", "from": { "node": "n" } } } } },
        "nodes": { "a": { "type": { "phenomenon": "p" } }, "b": { "type": { "file": "grey.json" } },
                   "sum": { "type": "add", "inputs": { "a": { "node": "a" }, "b": { "node": "b" } } } },
        "roots": { "material": { "node": "sum" } } }"#;
    let grey = r#"{ "phenomenon": "grey", "roots": { "material": 0.25 } }"#;
    let graph = graph(&[("a.json", text), ("grey.json", grey)]);
    assert_eq!(color(&graph, &[])[0], 0.5);
    // A file that is not there is told once, wherever it is named.
    let missing = check_files(&[("a.json", text)]);
    let codes: Vec<Code> = missing.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, [Code::UNREADABLE_FILE]);
    // A file that names itself from within is a part of itself.
    let own = text.replace("grey.json", "a.json");
    let checked = check_files(&[("a.json", &own)]);
    assert!(checked.findings.iter().all(|finding| finding.code == Code::RECURSION));
    assert!(!checked.findings.is_empty());
}

#[test]
fn mistakes_within_are_placed_there_and_all_are_told() {
    let text = r#"{ "phenomenon": "u",
        "phenomena": { "p": { "nodes": { "n": { "type": "mixx" } },
                              "outputs": { "x": { "type": "color", "from": { "node": "n" } } } },
                       "q": { "nodes": { "n": { "type": "mix", "inputs": { "wieght": 1 } } },
                              "outputs": { "x": { "type": "color", "from": { "node": "n" } } } },
                       "r": { "outputs": { "x": { "type": "color", "from": 1 } } } },
        "nodes": { "a": { "type": { "phenomenon": "p" } }, "b": { "type": { "phenomenon": "q" } },
                   "c": { "type": { "phenomenon": "r" }, "inputs": { "y": 1 } },
                   "sum": { "type": "sum", "inputs": { "values": [{ "node": "a" }, { "node": "b" }, { "node": "c" }] } } },
        "roots": { "material": { "node": "sum" } } }"#;
    let checked = check(text);
    let told: Vec<(&str, Code)> =
        checked.findings.iter().map(|it| (it.place.path.as_str(), it.code)).collect();
    assert_eq!(
        told,
        [
            ("phenomena.p.nodes.n.type", Code::UNKNOWN_NODE_TYPE),
            ("phenomena.q.nodes.n.inputs.wieght", Code::UNKNOWN_INPUT),
            ("nodes.c.inputs.y", Code::UNKNOWN_INPUT),
        ]
    );
}

#[test]
fn chains_of_phenomena_are_bounded() {
    let chain = |length: usize| {
        let mut phenomena =
            String::from(r#""p0": { "outputs": { "x": { "type": "scalar", "from": 1 } } }"#);
        for at in 1..length {
            phenomena += &format!(
                r#", "p{at}": {{ "nodes": {{ "n": {{ "type": {{ "phenomenon": "p{}" }} }} }},
                     "outputs": {{ "x": {{ "type": "scalar", "from": {{ "node": "n" }} }} }} }}"#,
                at - 1
            );
        }
        format!(
            r#"{{ "phenomenon": "u", "phenomena": {{ {phenomena} }},
                 "nodes": {{ "n": {{ "type": {{ "phenomenon": "p{}" }} }} }},
                 "roots": {{ "material": {{ "node": "n" }} }} }}"#,
            length - 1
        )
    };
    // The file is one of them.
    assert_eq!(codes(&chain(MAX_FILE_DEPTH - 1)), []);
    assert_eq!(codes(&chain(MAX_FILE_DEPTH)), [Code::RECURSION]);
    assert_eq!(codes(&chain(1000)), [Code::RECURSION], "told once, and no stack overflows");
}

#[test]
fn phenomena_that_multiply_are_bounded() {
    // Each is two of the one before.
    let mut phenomena = String::from(
        r#""p0": { "nodes": { "here": { "type": "state" } },
                   "outputs": { "x": { "type": "scalar", "from": { "node": "here", "output": "dot_nd" } } } }"#,
    );
    for at in 1..=24 {
        let before = at - 1;
        phenomena += &format!(
            r#", "p{at}": {{ "nodes": {{ "a": {{ "type": {{ "phenomenon": "p{before}" }} }},
                                        "b": {{ "type": {{ "phenomenon": "p{before}" }} }},
                                        "c": {{ "type": "add", "inputs": {{ "a": {{ "node": "a" }}, "b": {{ "node": "b" }} }} }} }},
                 "outputs": {{ "x": {{ "type": "scalar", "from": {{ "node": "c" }} }} }} }}"#
        );
    }
    let text = format!(
        r#"{{ "phenomenon": "u", "phenomena": {{ {phenomena} }},
             "nodes": {{ "n": {{ "type": {{ "phenomenon": "p24" }} }} }},
             "roots": {{ "material": {{ "node": "n" }} }} }}"#
    );
    assert_eq!(codes(&text), [Code::TOO_MANY_NODES]);
}
