//! Graphs of expressions, and what they compute.

use std::sync::Arc;

use phenomenon_compiler::check::check_graph;
use phenomenon_compiler::document::read;
use phenomenon_compiler::engine::{Options, Shade, Shaded, Shader};
use phenomenon_compiler::graph::{Graph, RootKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::state::State;
use phenomenon_compiler::testing::mock::MockRenderer;

/// A graph that is right.
pub fn graph(text: &str) -> Graph {
    let document = read("expressions.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &NodeLibrary::standard());
    let told: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    checked.graph.unwrap_or_else(|| panic!("{text}\n{}", told.join("\n")))
}

/// Its colour at the usual point.
pub fn shaded(graph: &Arc<Graph>, options: Options, renderer: &mut MockRenderer) -> [f32; 4] {
    let shader = Shader::new(Arc::clone(graph), &[], options).expect("it compiles");
    let mut results = [Shaded { color: [f32::NAN; 4], ok: false }];
    shader.shade(RootKind::Material, &[State::default()], renderer, &mut results);
    results[0].color
}

/// A graph with names of every kind, and room for a root.
pub const GRAPH: &str = r#"{
    "phenomenon": "random",
    "interface": {
        "a": { "type": "scalar", "default": 0.75 }, "b": { "type": "scalar", "default": -1.25 },
        "zero": { "type": "scalar", "default": 0 }, "count": { "type": "integer", "default": 3 },
        "v": { "type": "vector", "default": [1.5, -0.5, 0.25] },
        "c": { "type": "color", "default": [0.25, 0.5, 1.0, 0.5] },
        "look": { "type": "struct", "members": {
            "tint": { "type": "color", "default": [0.75, 0, 2] },
            "weights": { "type": "array", "of": { "type": "scalar" }, "default": [1, 0.125] } } },
        "on": { "type": "boolean", "default": true }, "off": { "type": "boolean", "default": false }
    },
    "nodes": {
        "place": { "type": "constant_vector", "inputs": { "value": [0.5, 2, -3] } },
        "paint": { "type": "constant_color", "inputs": { "value": [0.5, 0.25, 0.125, 0.75] } },
        "doubled": { "type": "add", "inputs": { "a": { "interface": "v" }, "b": { "expression": "v" } } },
        "apart": { "type": "split_vector", "inputs": { "vector": { "interface": "v" } } }
    },
    "roots": { "material": ROOT } }"#;

/// What is said of a text: code, the bytes it is about, and the message.
pub fn told(text: &str) -> Vec<String> {
    let document = read("expressions.json", text.as_bytes()).expect("it is JSON");
    let checked = check_graph(&document, &NodeLibrary::standard());
    let told = checked.findings.iter().map(|finding| {
        let place = &finding.place;
        format!("{} at {}: {}", finding.code, &text[place.start..place.end], finding.message)
    });
    told.collect()
}
