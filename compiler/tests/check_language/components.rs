//! Components of outputs and of parameters, and colours of other spaces.

use phenomenon_compiler::check::bind_text;
use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::{Binding, RootKind};
use phenomenon_compiler::state::State;
use phenomenon_compiler::values::Literal;

use super::files::{check, codes, graph};
use super::shading::{color, shaded};

#[test]
fn components_are_taken_of_outputs_and_parameters() {
    let text = r#"{ "phenomenon": "a",
        "interface": { "tint": { "type": "color", "default": [2, 3, 5, 7] },
                       "look": { "type": "struct", "members": { "up": { "type": "vector", "default": [11, 13, 17] } } } },
        "nodes": {
            "here": { "type": "state" },
            "sum": { "type": "add", "inputs": { "a": { "node": "here", "output": "normal" }, "b": 1 } },
            "all": { "type": "combine_color", "inputs": {
                "r": { "node": "here", "output": "normal.y" }, "g": { "node": "sum", "output": "y" },
                "b": { "interface": "tint.b" }, "a": { "interface": "look.up.z" } } },
            "more": { "type": "sum", "inputs": { "values": [
                { "node": "here", "output": "normal.y" }, { "interface": "tint.a" }, { "node": "sum", "output": "result.x" }] } },
            "both": { "type": "scale", "inputs": { "input": { "node": "all" }, "factor": { "node": "more" } } } },
        "roots": { "material": { "node": "both" } } }"#;
    let graph = graph(&[("a.json", text)]);
    let names: Vec<&str> = graph.nodes.iter().map(|node| node.name.as_str()).collect();
    for name in ["here.normal.*", "sum.result.*", "interface.tint.*", "interface.look.up.*"] {
        assert_eq!(names.iter().filter(|it| **it == name).count(), 1, "{name}: {names:?}");
    }
    let state = State { normal: [0.5, 0.25, 1.0], ..State::default() };
    let (color, _) = shaded(&graph, RootKind::Material, &[], state);
    // 0.25 + 7 + 1.5
    let factor = 8.75;
    assert_eq!(color, [0.25 * factor, 1.25 * factor, 5.0 * factor, 17.0], "the alpha stays");
    let value = [("tint", Literal::Color([0.0, 0.0, 1.0, 0.0]))];
    let (color, _) = shaded(&graph, RootKind::Material, &value, state);
    assert_eq!(color[2], 1.75);
}

#[test]
fn components_are_scalars_wherever_values_stand() {
    let root = |root: &str| {
        let text = format!(
            r#"{{ "phenomenon": "a", "nodes": {{ "here": {{ "type": "state" }} }}, "roots": {{ "material": {root} }} }}"#
        );
        let (color, _) = shaded(
            &graph(&[("a.json", &text)]),
            RootKind::Material,
            &[],
            State { normal: [0.5, 0.25, 1.0], ..State::default() },
        );
        color
    };
    assert_eq!(root(r#"{ "node": "here", "output": "normal.y" }"#), [0.25, 0.25, 0.25, 1.0]);
    let listed =
        r#"[{ "node": "here", "output": "normal.x" }, { "node": "here", "output": "normal.z" }]"#;
    assert_eq!(root(listed), [1.0; 4], "the last shader of a list has the last word");
    // A node whose output has a stop in no name: what is an output as a whole is no component.
    let text = r#"{ "phenomenon": "a", "nodes": { "s": { "type": "split_vector" } },
        "roots": { "material": { "node": "s", "output": "y" } } }"#;
    assert_eq!(graph(&[("a.json", text)]).nodes.len(), 1);
}

#[test]
fn what_is_no_component_is_told_within_the_text() {
    let text = r#"{ "phenomenon": "a",
        "nodes": { "here": { "type": "state" },
                   "sum": { "type": "add", "inputs": { "a": { "node": "here", "output": "normal" } } } },
        "roots": { "material": { "node": "sum", "output": "result.g" } } }"#;
    let checked = check(text);
    assert_eq!(checked.findings.len(), 1);
    let finding = &checked.findings[0];
    assert_eq!((finding.code, finding.place.text()), (Code::UNKNOWN_OUTPUT, "g"));
    assert_eq!(finding.fix.as_deref(), Some("y"));
}

fn default_of(literal: &str) -> Literal {
    let text = format!(
        r#"{{ "phenomenon": "a", "interface": {{ "tint": {{ "type": "color", "default": {literal} }} }},
             "roots": {{ "material": {{ "interface": "tint" }} }} }}"#
    );
    graph(&[("a.json", &text)]).parameters[0].default.clone()
}

#[test]
fn colors_of_other_spaces_are_converted_and_rounded_once() {
    // 128 / 255 decoded in 64 bits.
    let half = (((128.0_f64 / 255.0) + 0.055) / 1.055).powf(2.4) as f32;
    assert_eq!(default_of(r##"{ "srgb": "#ff8000" }"##), Literal::Color([1.0, half, 0.0, 1.0]));
    let cc = f64::from(0xcc) / 255.0;
    let alpha = Literal::Color([1.0, half, 0.0, cc as f32]);
    assert_eq!(default_of(r##"{ "srgb_texture": "#FF8000cc" }"##), alpha, "alpha is not encoded");
    assert_eq!(default_of(r##"{ "srgb": "#f00" }"##), Literal::Color([1.0, 0.0, 0.0, 1.0]));
    assert_eq!(default_of(r#"{ "srgb": 1 }"#), Literal::Color([1.0; 4]));
    let linear = Literal::Color([0.5, -2.0, 3.0, 0.25]);
    assert_eq!(default_of(r#"{ "lin_rec709": [0.5, -2, 3, 0.25] }"#), linear);
    let Literal::Color([r, g, b, a]) = default_of(r#"{ "acescg": [0.5, 0.25, 0.75] }"#) else {
        panic!("a colour");
    };
    for (ours, theirs) in [r, g, b].iter().zip([0.634_633_2, 0.212_162_26, 0.820_485_23_f32]) {
        assert!((ours - theirs).abs() < 1e-6, "{ours} {theirs}");
    }
    assert_eq!(a, 1.0);
}

#[test]
fn colors_of_other_spaces_stand_wherever_colors_do() {
    let text = r##"{ "phenomenon": "a",
        "interface": {
            "tints": { "type": "array", "of": { "type": "color" }, "default": [{ "srgb": "#fff" }, [0, 1, 0]] },
            "look": { "type": "struct", "members": { "tint": { "type": "color", "default": { "srgb": "#f00" } } } } },
        "nodes": {
            "all": { "type": "sum", "inputs": { "values": [
                { "interface": "tints[0]" }, { "interface": "tints[1]" }, { "interface": "look.tint" }, { "srgb": "#00f" }] } },
            "half": { "type": "scale", "inputs": { "input": { "node": "all" }, "factor": 0.5 } } },
        "roots": { "material": { "node": "half" }, "shadow": { "srgb": "#fff" } } }"##;
    let graph = graph(&[("a.json", text)]);
    assert_eq!(color(&graph, &[])[..3], [1.0, 1.0, 1.0]);
    assert_eq!(graph.roots[1].color, Binding::Literal(Literal::Color([1.0; 4])));
    let values = bind_text(&graph, "look.tint", r##"{ "srgb": "#0f0" }"##).unwrap();
    assert_eq!(values, [("look.tint".to_owned(), Literal::Color([0.0, 1.0, 0.0, 1.0]))]);
    assert!(bind_text(&graph, "look.tint", r#"{ "srgb": [0, 300, 0] }"#).is_err());
    let generic = r##"{ "phenomenon": "a", "nodes": { "n": { "type": "add", "inputs": { "a": { "srgb": "#fff" }, "b": 1 } } },
        "roots": { "material": { "node": "n" } } }"##;
    assert_eq!(codes(generic), []);
}
