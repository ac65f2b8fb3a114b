//! Arrays, structs and lists.

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;

use super::files::{check_files, graph};
use super::shading::{color, shaded};

const LAYERS: &str = r#"{
    "phenomenon": "layers",
    "interface": {
        "layers": {
            "type": "array",
            "of": { "type": "struct", "members": {
                "tint": { "type": "color", "default": [0.5, 0.5, 0.5] },
                "weights": { "type": "array", "of": { "type": "scalar", "min": 0, "max": 8 },
                             "default": [1, 2] } } },
            "default": [{ "struct": {} }, { "struct": { "tint": [1, 0, 0], "weights": [4, 8] } }]
        }
    },
    "nodes": {
        "first": { "type": "scale", "inputs": { "input": { "interface": "layers[0].tint" },
                                                "factor": { "interface": "layers[0].weights[1]" } } },
        "second": { "type": "scale", "inputs": { "input": { "interface": "layers[1].tint" },
                                                 "factor": { "interface": "layers[1].weights[0]" } } },
        "both": { "type": "add", "inputs": { "a": { "node": "first" }, "b": { "node": "second" } } },
        "rest": { "type": "sum", "inputs": { "values": { "interface": "layers[0].weights" } } },
        "shade": { "type": "multiply", "inputs": { "a": { "node": "both" }, "b": { "node": "rest" } } }
    },
    "roots": { "material": { "node": "shade" } }
}"#;

#[test]
fn every_part_of_arrays_and_structs_is_a_parameter() {
    let graph = graph(&[("layers.json", LAYERS)]);
    let names: Vec<&str> = graph.parameters.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "layers[0].tint",
            "layers[0].weights[0]",
            "layers[0].weights[1]",
            "layers[1].tint",
            "layers[1].weights[0]",
            "layers[1].weights[1]"
        ]
    );
    assert_eq!(graph.parameters[1].range, 0.0..=8.0);
    assert_eq!(color(&graph, &[]), [15.0, 3.0, 3.0, 1.0]);
    let value = graph.bind("layers[1].weights[0]", "0.5").unwrap();
    assert_eq!(color(&graph, &[("layers[1].weights[0]", value)]), [4.5, 3.0, 3.0, 1.0]);
    assert!(graph.bind("layers[1].weights[0]", "9").is_err(), "ranges hold for every element");
    let error = graph.bind("layers[2].tint", "1").unwrap_err().to_string();
    assert!(error.contains("`layers` has 2 values, 0 to 1"), "{error}");
}

#[test]
fn compounds_are_handed_to_phenomena_whole_and_in_parts() {
    let with = |inputs: &str| {
        format!(
            r#"{{ "phenomenon": "user",
                "interface": {{ "own": {{ "type": "array", "of": {{ "type": "struct", "members": {{
                    "tint": {{ "type": "color", "default": [0, 1, 0] }},
                    "weights": {{ "type": "array", "of": {{ "type": "integer" }}, "default": [1, 1] }} }} }},
                    "default": [{{ "struct": {{}} }}, {{ "struct": {{}} }}] }} }},
                "nodes": {{ "n": {{ "type": {{ "file": "layers.json" }}, "inputs": {{ {inputs} }} }},
                            "keep": {{ "type": "scale", "inputs": {{ "input": {{ "interface": "own[0].tint" }}, "factor": {{ "interface": "own[1].weights[1]" }} }} }},
                            "out": {{ "type": "add", "inputs": {{ "a": {{ "node": "n" }}, "b": {{ "node": "keep" }} }} }} }},
                "roots": {{ "material": {{ "node": "out" }} }} }}"#
        )
    };
    let shade = |inputs: &str| {
        let text = with(inputs);
        let checked = check_files(&[("user.json", &text), ("layers.json", LAYERS)]);
        let errors: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
        color(&checked.graph.unwrap_or_else(|| panic!("{errors:?}")), &[])
    };
    // Whole: integers become the scalars the other wants.
    assert_eq!(shade(r#""layers": { "interface": "own" }"#), [0.0, 5.0, 0.0, 1.0]);
    // An element is a part of the own array, the other one a literal whose missing parts have defaults.
    let mixed = r#""layers": [{ "interface": "own[0]" }, { "struct": { "tint": [0, 0, 1] } }]"#;
    assert_eq!(shade(mixed), [0.0, 3.0, 8.0, 1.0]);
    let wrong = |inputs: &str| -> Vec<Code> {
        let text = with(inputs);
        let checked = check_files(&[("user.json", &text), ("layers.json", LAYERS)]);
        checked.findings.iter().map(|finding| finding.code).collect()
    };
    assert_eq!(wrong(r#""layers": { "interface": "own[0]" }"#), [Code::TYPE_MISMATCH]);
    assert_eq!(wrong(r#""layers": { "interface": "own[0].tint" }"#), [Code::TYPE_MISMATCH]);
    assert_eq!(wrong(r#""layers": [{ "struct": {} }]"#), [Code::WRONG_LENGTH]);
    assert_eq!(
        wrong(r#""layers": [{ "struct": { "weights": [1, 99] } }, { "struct": {} }]"#),
        [Code::NUMBER_OUT_OF_RANGE]
    );
}

#[test]
fn an_element_is_chosen_lazily_and_passes_unchanged() {
    let text = r#"{ "phenomenon": "choice",
        "interface": { "which": { "type": "integer", "default": 0 } },
        "nodes": {
            "mirror": { "type": "trace_reflection" },
            "glass": { "type": "trace_refraction", "inputs": { "direction": [0, 0, -1] } },
            "shade": { "type": "element", "inputs": { "index": { "interface": "which" }, "values": [
                [-0.0, 1e-45, 0.25, 0.75], { "node": "mirror" }, { "node": "glass" }, 3 ] } } },
        "roots": { "material": { "node": "shade" } } }"#;
    let graph = graph(&[("choice.json", text)]);
    let chosen = |which: i32| {
        let value = Literal::Integer(which);
        let (color, asked) =
            shaded(&graph, RootKind::Material, &[("which", value)], State::default());
        (color.map(f32::to_bits), asked.rays)
    };
    let first = ([-0.0_f32, 1e-45, 0.25, 0.75].map(f32::to_bits), 0);
    assert_eq!([chosen(i32::MIN), chosen(-1), chosen(0)], [first; 3]);
    assert_eq!(chosen(1), ([1.0_f32; 4].map(f32::to_bits), 1));
    assert_eq!(chosen(2), ([0.5_f32, 0.5, 0.5, 1.0].map(f32::to_bits), 1));
    let last = ([3.0_f32, 3.0, 3.0, 1.0].map(f32::to_bits), 0);
    assert_eq!([chosen(3), chosen(4), chosen(i32::MAX)], [last; 3]);
}

#[test]
fn sums_run_in_list_order() {
    let sum = |values: &str| {
        let text = format!(
            r#"{{ "phenomenon": "sum", "nodes": {{ "s": {{ "type": "sum", "inputs": {{ "values": {values} }} }} }},
               "roots": {{ "material": {{ "node": "s" }} }} }}"#
        );
        color(&graph(&[("sum.json", &text)]), &[])
    };
    assert_eq!(sum("[1e8, 1, -1e8]")[0], 0.0, "1 is lost in the first sum");
    assert_eq!(sum("[1e8, -1e8, 1]")[0], 1.0);
    assert_eq!(sum("[-0.0]")[0].to_bits(), (-0.0_f32).to_bits(), "one value is itself");
    assert_eq!(sum("[[1, 2, 3, 0.25], 1, [0, 0, 1, 7]]"), [2.0, 3.0, 5.0, 0.25]);
}

#[test]
fn what_is_given_twice_or_beside_a_struct_is_told() {
    let inner = r#"{ "phenomenon": "inner", "interface": {
            "s": { "type": "struct", "members": { "a": { "type": "scalar", "default": 1 }, "b": { "type": "scalar", "default": 1 } } },
            "mode": { "type": "integer", "default": "soft", "values": ["soft", "hard"] } },
        "nodes": { "x": { "type": "sum", "inputs": { "values": [{ "interface": "s.a" }, { "interface": "s.b" }, { "interface": "mode" }] } } },
        "roots": { "material": { "node": "x" } } }"#;
    let with = |inputs: &str| {
        let outer = format!(
            r#"{{ "phenomenon": "outer", "interface": {{
                 "o": {{ "type": "struct", "members": {{ "b": {{ "type": "scalar", "default": 8 }}, "a": {{ "type": "scalar", "default": 4 }} }} }},
                 "t": {{ "type": "struct", "members": {{ "b": {{ "type": "color", "default": 8 }}, "a": {{ "type": "scalar", "default": 4 }} }} }} }},
               "nodes": {{ "n": {{ "type": {{ "file": "inner.json" }}, "inputs": {{ {inputs} }} }},
                 "keep": {{ "type": "sum", "inputs": {{ "values": [{{ "interface": "o.a" }}, {{ "interface": "o.b" }}, {{ "interface": "t.a" }}, {{ "interface": "t.b" }}] }} }},
                 "m": {{ "type": "mix", "inputs": {{ "weight": 0.5, "a": {{ "node": "n" }}, "b": {{ "node": "keep" }} }} }} }},
               "roots": {{ "material": {{ "node": "m" }}, "shadow": {{ "node": "n" }} }} }}"#
        );
        let checked = check_files(&[("outer.json", &outer), ("inner.json", inner)]);
        let found: Vec<(Code, String)> =
            checked.findings.iter().map(|it| (it.code, it.message.clone())).collect();
        let shadow =
            checked.graph.map(|graph| shaded(&graph, RootKind::Shadow, &[], State::default()).0);
        (found, shadow)
    };
    let code =
        |inputs: &str| -> Vec<Code> { with(inputs).0.into_iter().map(|(code, _)| code).collect() };
    assert_eq!(code(r#""s": { "struct": { "a": 1 } }, "s.a": 7"#), [Code::DUPLICATE_KEY]);
    assert_eq!(code(r#""s": { "struct": { "a": 1 }, "unit": "mm" }"#), [Code::UNKNOWN_KEY]);
    assert_eq!(with(r#""s": { "struct": { "a": 1 } }, "s.b": 7"#).1.unwrap()[0], 8.0);
    assert_eq!(with(r#""s": { "interface": "o" }"#).1.unwrap()[0], 12.0, "by name, in any order");
    let (found, _) = with(r#""s": { "interface": "t" }"#);
    assert_eq!(found.len(), 1);
    assert!(found[0].1.ends_with("its part `b` must be a scalar, not a color"), "{}", found[0].1);
    assert_eq!(with(r#""mode": "hard""#).1.unwrap()[0], 3.0);
    assert_eq!(code(r#""mode": "hrad""#), [Code::UNKNOWN_CHOICE]);
}
