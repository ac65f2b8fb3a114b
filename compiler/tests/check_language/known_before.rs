//! What is known of a graph before it runs.

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::graph::RootKind;

use super::files::{check_files, graph};

#[test]
fn requirements_are_joined_in_the_graph() {
    let inner = r#"{ "phenomenon": "inner",
        "requires": { "shadow": "sort", "texture": 2, "derivative": [2], "parallel": true, "volume_level": 3, "apply": ["material"] },
        "roots": { "material": 1 } }"#;
    let outer = r#"{ "phenomenon": "outer",
        "requires": { "shadow": "on", "texture": 1, "bump": 1, "derivative": [1], "parallel": false },
        "nodes": { "n": { "type": { "file": "inner.json" } }, "m": { "type": "trace_reflection" },
                   "s": { "type": "add", "inputs": { "a": { "node": "n" }, "b": { "node": "m" } } } },
        "roots": { "material": { "node": "s" } } }"#;
    let graph = graph(&[("outer.json", outer), ("inner.json", inner)]);
    let requirements = &graph.requirements;
    assert_eq!(requirements.choices, [("shadow", "sort"), ("trace", "on")].into());
    assert_eq!((requirements.texture, requirements.bump, requirements.volume_level), (2, 1, 3));
    assert_eq!(requirements.derivative, [1, 2].into());
    assert_eq!(requirements.parallel, Some(false));
    assert!(requirements.applies_to(RootKind::Lens), "what the inner one is for is its own");
    let misused = outer.replace("\"material\"", "\"lens\"");
    let checked = check_files(&[("outer.json", &misused), ("inner.json", inner)]);
    let found: Vec<Code> = checked.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(found, [Code::CONFLICTING_REQUIREMENTS]);
}

#[test]
fn what_is_ruled_out_is_known_in_the_graph_through_phenomena() {
    let inner = r#"{ "phenomenon": "inner",
        "interface": { "share": { "type": "scalar", "default": 0, "min": 0, "max": 0 } },
        "nodes": { "t": { "type": "trace_reflection" },
                   "m": { "type": "mix", "inputs": { "weight": { "interface": "share" }, "b": { "node": "t" } } } },
        "roots": { "material": { "node": "m" } } }"#;
    let outer = r#"{ "phenomenon": "outer",
        "nodes": { "one": { "type": { "file": "inner.json" } },
                   "t": { "type": "trace_transparent" },
                   "two": { "type": { "file": "inner.json" } },
                   "s": { "type": "select", "inputs": { "condition": true, "if_true": { "node": "one" }, "if_false": { "node": "t" } } },
                   "m": { "type": "add", "inputs": { "a": { "node": "s" }, "b": { "node": "two" } } } },
        "roots": { "material": { "node": "m" } } }"#;
    let checked = check_files(&[("outer.json", outer), ("inner.json", inner)]);
    let graph = checked.graph.unwrap();
    let library = &graph.library;
    let named: Vec<(&str, &str)> = graph
        .ruled_out
        .iter()
        .map(|&(node, input)| {
            let node = &graph.nodes[node];
            (node.name.as_str(), &*library.signature(node.node_type).inputs[input].name)
        })
        .collect();
    assert_eq!(named, [("one/m", "b"), ("two/m", "b"), ("s", "if_false")]);
}
