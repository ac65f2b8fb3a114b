//! Presets: values of parameters under names; and the examples of the page on the format.

use std::path::Path;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::document::{read, read_file};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;

use super::files::{check, codes, graph};
use super::shading::color;

const GLASS: &str = r##"{ "phenomenon": "glass",
    "interface": {
        "tint": { "type": "color", "default": [1, 1, 1], "min": 0, "max": 1 },
        "kind": { "type": "integer", "values": ["thin", "thick"], "default": "thin" },
        "weights": { "type": "array", "of": { "type": "scalar" }, "default": [1, 2] } },
    "presets": {
        "clear": {},
        "smoke": { "tint": { "srgb": "#f00" }, "kind": "thick", "weights": [3, 4] },
        "half": { "weights[1]": 0 } },
    "nodes": {
        "sum": { "type": "sum", "inputs": { "values": { "interface": "weights" } } },
        "all": { "type": "add", "inputs": { "a": { "node": "sum" }, "b": { "interface": "kind" } } },
        "shade": { "type": "scale", "inputs": { "input": { "interface": "tint" }, "factor": { "node": "all" } } } },
    "roots": { "material": { "node": "shade" } } }"##;

#[test]
fn presets_give_values_and_what_is_set_counts_before_them() {
    let graph = graph(&[("glass.json", GLASS)]);
    let names: Vec<&str> = graph.presets.iter().map(|preset| preset.name.as_str()).collect();
    assert_eq!(names, ["clear", "smoke", "half"]);
    let shaded = |preset: &str, set: &[(&str, Literal)]| {
        let set = set.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
        let values = graph.preset(preset).unwrap().with(set);
        let values: Vec<(&str, Literal)> =
            values.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
        color(&graph, &values)
    };
    assert_eq!(shaded("clear", &[]), [3.0, 3.0, 3.0, 1.0]);
    assert_eq!(shaded("smoke", &[]), [8.0, 0.0, 0.0, 1.0]);
    assert_eq!(shaded("smoke", &[("weights[0]", Literal::Scalar(0.0))]), [5.0, 0.0, 0.0, 1.0]);
    assert_eq!(shaded("half", &[]), [1.0, 1.0, 1.0, 1.0]);
}

#[test]
fn values_of_presets_are_checked_as_what_is_set() {
    let with = |preset: &str| GLASS.replace(r#""clear": {}"#, &format!(r#""clear": {preset}"#));
    assert_eq!(codes(&with(r#"{ "tnit": 1 }"#)), [Code::UNKNOWN_PARAMETER]);
    assert_eq!(codes(&with(r#"{ "tint": 2 }"#)), [Code::NUMBER_OUT_OF_RANGE]);
    assert_eq!(codes(&with(r#"{ "kind": "thcik" }"#)), [Code::UNKNOWN_CHOICE]);
    assert_eq!(codes(&with(r#"{ "weights": [1] }"#)), [Code::WRONG_LENGTH]);
    assert_eq!(codes(&with(r#"{ "weights": [1, 2], "weights[0]": 1 }"#)), [Code::DUPLICATE_KEY]);
    assert_eq!(codes(&with(r#"{ "tint": { "interface": "tint" } }"#)), [Code::TYPE_MISMATCH]);
    assert_eq!(codes(&with("[]")), [Code::WRONG_KIND]);
    let checked = check(&with(r#"{ "tint": { "srgb": [0, 2, 0] } }"#));
    let place = &checked.findings[0].place;
    assert_eq!(place.path, "presets.clear.tint.srgb[1]");
}

#[test]
fn the_examples_of_the_page_are_right() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/graph-format.md");
    let page = std::fs::read_to_string(page).unwrap();
    let blocks = page.split("```json\n").skip(1).filter_map(|rest| rest.split("```").next());
    let mut whole = 0;
    for block in blocks {
        // A part of a file is one with braces round it.
        let is_whole = block.starts_with('{');
        let text = if is_whole { block.to_owned() } else { format!("{{ {block} }}") };
        let document = read("example.json", text.as_bytes());
        assert!(document.is_ok(), "{block}");
        if is_whole {
            whole += 1;
            let told = check(block).findings;
            assert!(told.is_empty(), "{told:?}");
        }
    }
    assert!(whole >= 1);
}

#[test]
fn shipped_presets_are_there() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs");
    for (file, presets) in [
        ("glass/advanced_glass.json", &["moldavite", "clear", "smoke"][..]),
        ("painted/ripples.json", &["calm", "lava"]),
    ] {
        let document = read_file(&folder.join(file)).unwrap();
        let library = NodeLibrary::standard();
        let graph = phenomenon_compiler::check::check_graph(&document, &library).graph.unwrap();
        let names: Vec<&str> = graph.presets.iter().map(|preset| preset.name.as_str()).collect();
        assert_eq!(names, presets, "{file}");
    }
}
