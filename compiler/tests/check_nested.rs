//! Phenomena inside phenomena: expansion, recursion, limits, what they require.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use phenomenon_compiler::check::{Checked, Files, MAX_FILE_DEPTH, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile};
use phenomenon_compiler::document::{Document, read};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;

/// Files that exist in memory only.
#[derive(Default)]
struct InMemory(HashMap<PathBuf, String>);

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let name = path.display().to_string();
        match self.0.get(&self.identity(path)) {
            Some(text) => read(&name, text.as_bytes()),
            None => {
                let file = Arc::new(SourceFile::new(name, ""));
                let place = Place { file, start: 0, end: 0, path: String::new() };
                Err(Box::new(Finding::new(Code::UNREADABLE_FILE, place, "no such file", "")))
            }
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.components().filter(|part| part.as_os_str() != ".").collect()
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        (!self.0.contains_key(&self.identity(path))).then(|| "no such file".into())
    }
}

fn check(files: &[(&str, String)]) -> Checked {
    let memory: InMemory =
        InMemory(files.iter().map(|(name, text)| (PathBuf::from(name), text.clone())).collect());
    let document = read(files[0].0, files[0].1.as_bytes()).unwrap();
    check_graph_with(&document, &NodeLibrary::standard(), &memory)
}

fn graph(files: &[(&str, String)]) -> Graph {
    let checked = check(files);
    let findings: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    checked.graph.unwrap()
}

fn codes(files: &[(&str, String)]) -> Vec<Code> {
    check(files).findings.iter().map(|finding| finding.code).collect()
}

/// A phenomenon with that interface, those nodes and that material.
fn phenomenon(interface: &str, nodes: &str, material: &str) -> String {
    format!(
        "{{\"phenomenon\":\"p\",\"interface\":{{{interface}}},\"nodes\":{{{nodes}}},\"roots\":{{\"material\":{material}}}}}"
    )
}

const TINT: &str = r#""tint":{"type":"color","default":[1,0.5,0],"min":0,"max":1}"#;

fn inner() -> String {
    phenomenon(
        TINT,
        r#""mirror":{"type":"trace_reflection"},"out":{"type":"multiply","inputs":{"a":{"node":"mirror"},"b":{"interface":"tint"}}}"#,
        r#"{"node":"out"}"#,
    )
}

fn user(inputs: &str) -> String {
    phenomenon(
        "",
        &format!(
            r#""shade":{{"type":{{"file":"inner.json"}},"inputs":{{{inputs}}}}},"sum":{{"type":"add","inputs":{{"a":{{"node":"shade"}},"b":0.5}}}}"#
        ),
        r#"{"node":"sum"}"#,
    )
}

#[test]
fn nodes_of_a_phenomenon_stand_in_its_place() {
    let graph = graph(&[("a.json", user("")), ("inner.json", inner())]);
    let names: Vec<&str> = graph.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["shade/mirror", "shade/out", "sum"]);
    assert_eq!(graph.nodes[1].inputs[0], Binding::Node { node: 0, output: 0 });
    let default = Binding::Literal(Literal::Color([1.0, 0.5, 0.0, 1.0]));
    assert_eq!(graph.nodes[1].inputs[1], default);
    assert_eq!(graph.nodes[2].inputs[0], Binding::Node { node: 1, output: 0 });
    assert_eq!(graph.roots[0].color, Binding::Node { node: 2, output: 0 });
}

#[test]
fn a_number_given_to_a_colour_parameter_is_grey() {
    let graph = graph(&[("a.json", user("\"tint\":0.25")), ("inner.json", inner())]);
    let grey = Binding::Literal(Literal::Color([0.25, 0.25, 0.25, 1.0]));
    assert_eq!(graph.nodes[1].inputs[1], grey);
}

#[test]
fn a_phenomenon_may_hand_a_parameter_through() {
    let through = phenomenon(TINT, "", r#"{"interface":"tint"}"#);
    let outer = phenomenon(
        TINT,
        r#""x":{"type":{"file":"b.json"},"inputs":{"tint":{"interface":"tint"}}},
           "y":{"type":{"file":"./b.json"},"inputs":{"tint":{"node":"x"}}},
           "z":{"type":{"file":"b.json"}}, "ok":{"type":"and","inputs":{"a":{"node":"y","output":"ok"}}}"#,
        r#"{"color":{"node":"y"},"ok":{"node":"ok"}}"#,
    );
    let outer = outer.replace("\"roots\":{", "\"roots\":{\"shadow\":{\"node\":\"z\"},");
    let graph = graph(&[("a.json", outer), ("b.json", through)]);
    assert_eq!(graph.nodes.len(), 1);
    assert_eq!(graph.nodes[0].inputs[0], Binding::Literal(Literal::Boolean(true)));
    assert_eq!(graph.roots[0].color, Binding::Literal(Literal::Color([1.0, 0.5, 0.0, 1.0])));
    assert_eq!(graph.roots[1].color, Binding::Parameter(0));
}

#[test]
fn a_long_way_through_phenomena_takes_linear_time() {
    let through = phenomenon(TINT, "", r#"{"interface":"tint"}"#);
    let mut nodes = String::from(r#""n0":{"type":{"file":"b.json"}}"#);
    for at in 1..50_000 {
        write!(
            nodes,
            r#","n{at}":{{"type":{{"file":"b.json"}},"inputs":{{"tint":{{"node":"n{}"}}}}}}"#,
            at - 1
        )
        .unwrap();
    }
    let outer = phenomenon("", &nodes, r#"{"node":"n49999"}"#);
    let started = Instant::now();
    let graph = graph(&[("a.json", outer), ("b.json", through)]);
    assert!(graph.nodes.is_empty());
    assert!(started.elapsed() < Duration::from_secs(20), "{:?}", started.elapsed());
}

#[test]
fn recursion_shows_the_way_through_the_files() {
    let uses = |file: &str| {
        phenomenon("", &format!(r#""n":{{"type":{{"file":"{file}"}}}}"#), r#"{"node":"n"}"#)
    };
    let itself = check(&[("a.json", uses("a.json"))]);
    assert_eq!(itself.findings.len(), 1);
    assert_eq!(itself.findings[0].message, "`a.json` uses itself");
    let round = check(&[
        ("a.json", uses("b.json")),
        ("b.json", uses("c.json")),
        ("c.json", uses("./a.json")),
    ]);
    assert_eq!(round.findings.len(), 1, "{:?}", round.findings);
    let finding = &round.findings[0];
    assert_eq!(finding.code, Code::RECURSION);
    assert_eq!(
        finding.message,
        "phenomena use one another: `a.json` → `b.json` → `c.json` → `a.json`"
    );
    assert_eq!(finding.place.file.name, "c.json");
    let related: Vec<&str> = finding.related.iter().map(|it| it.place.file.name.as_str()).collect();
    assert_eq!(related, ["a.json", "b.json"]);
}

#[test]
fn doubling_nests_do_not_explode() {
    let twice = |file: &str| {
        phenomenon(
            "",
            &format!(
                r#""x":{{"type":{{"file":"{file}"}}}},"y":{{"type":{{"file":"{file}"}}}},"n":{{"type":"add","inputs":{{"a":{{"node":"x"}},"b":{{"node":"y"}}}}}}"#
            ),
            r#"{"node":"n"}"#,
        )
    };
    let names: Vec<String> = (0..=30).map(|at| format!("f{at}.json")).collect();
    let mut files: Vec<(&str, String)> = Vec::new();
    for at in 0..30 {
        files.push((&names[at], twice(&names[at + 1])));
    }
    files.push((&names[30], inner()));
    let started = Instant::now();
    assert_eq!(codes(&files), [Code::TOO_MANY_NODES]);
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
}

#[test]
fn files_are_nested_to_a_limit() {
    let uses = |file: &str| {
        phenomenon("", &format!(r#""n":{{"type":{{"file":"{file}"}}}}"#), r#"{"node":"n"}"#)
    };
    for (depth, expected) in [(MAX_FILE_DEPTH, &[][..]), (MAX_FILE_DEPTH + 1, &[Code::RECURSION])] {
        let names: Vec<String> = (0..depth).map(|at| format!("f{at}.json")).collect();
        let mut files: Vec<(&str, String)> = Vec::new();
        for at in 0..depth - 1 {
            files.push((&names[at], uses(&names[at + 1])));
        }
        files.push((&names[depth - 1], inner()));
        assert_eq!(codes(&files), expected);
    }
}

#[test]
fn a_file_may_be_called_as_a_node_is() {
    let mixes = r#""out":{"type":"mix","inputs":{"a":{"interface":"tint"},"b":0.5,"weight":0.5}}"#;
    let named = phenomenon(TINT, mixes, r#"{"node":"out"}"#);
    let outer = phenomenon(
        "",
        r#""x":{"type":{"file":"mix"}},"y":{"type":"mix","inputs":{"a":{"node":"x"},"b":1,"weight":0.5}}"#,
        r#"{"node":"y"}"#,
    );
    let graph = graph(&[("a.json", outer), ("mix", named)]);
    let library = NodeLibrary::standard();
    let names: Vec<&str> = graph.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["x/out", "y"]);
    let signature = library.signature(graph.nodes[1].node_type);
    assert_eq!(signature.name, "mix");
    let a = signature.input("a").unwrap();
    assert_eq!(graph.nodes[1].inputs[a], Binding::Node { node: 0, output: 0 });
}

#[test]
fn mistakes_with_phenomena_are_found() {
    let with = |inputs: &str| codes(&[("a.json", user(inputs)), ("inner.json", inner())]);
    assert_eq!(with("\"tnit\":1"), [Code::UNKNOWN_INPUT]);
    assert_eq!(with("\"tint\":true"), [Code::TYPE_MISMATCH]);
    assert_eq!(with("\"tint\":[0,9,0]"), [Code::NUMBER_OUT_OF_RANGE]);
    assert_eq!(codes(&[("a.json", user(""))]), [Code::UNREADABLE_FILE]);
    assert_eq!(codes(&[("a.json", user("")), ("inner.json", "{".into())]), [Code::SYNTAX]);
    let broken = inner().replace("trace_reflection", "trace_reflektion");
    let checked = check(&[("a.json", user("")), ("inner.json", broken)]);
    assert_eq!(checked.findings.len(), 1, "{:?}", checked.findings);
    assert_eq!(checked.findings[0].place.file.name, "inner.json");
    let rootless = r#"{"phenomenon":"p","roots":{}}"#.to_owned();
    assert_eq!(codes(&[("a.json", user("")), ("inner.json", rootless)]), [Code::MISSING_ROOT]);
    let any_root = r#"{"phenomenon":"p","roots":{"lens":1}}"#.to_owned();
    assert_eq!(codes(&[("a.json", user("")), ("inner.json", any_root)]), []);
    let version =
        user("").replace("{\"file\":\"inner.json\"}", "{\"file\":\"inner.json\"},\"version\":3");
    assert_eq!(
        codes(&[("a.json", version.clone()), ("inner.json", inner())]),
        [Code::VERSION_MISMATCH]
    );
    let third = inner().replace("\"interface\"", "\"version\":3,\"interface\"");
    let third = third.replace("{\"version\":3,\"interface\":\"tint\"}", "{\"interface\":\"tint\"}");
    assert!(codes(&[("a.json", version), ("inner.json", third)]).is_empty());
}

#[test]
fn requirements_are_joined_over_files() {
    let requires = |text: String, requires: &str| {
        text.replacen(
            "\"phenomenon\":\"p\"",
            &format!("\"phenomenon\":\"p\",\"requires\":{{{requires}}}"),
            1,
        )
    };
    let off = requires(user(""), "\"trace\":\"off\"");
    assert_eq!(
        codes(&[("a.json", off), ("inner.json", inner())]),
        [Code::CONFLICTING_REQUIREMENTS]
    );
    let sorted = requires(inner(), "\"shadow\":\"sort\"");
    let with = |shadow: &str| {
        let outer = requires(user(""), &format!("\"shadow\":\"{shadow}\""));
        codes(&[("a.json", outer), ("inner.json", sorted.clone())])
    };
    assert!(with("on").is_empty() && with("sort").is_empty());
    assert_eq!(with("segments"), [Code::CONFLICTING_REQUIREMENTS]);
    assert_eq!(with("off"), [Code::CONFLICTING_REQUIREMENTS]);
}

/// A pattern with a count and a choice of its own.
fn pattern() -> (&'static str, String) {
    let text = r#"{ "phenomenon": "pattern", "interface": {
        "octaves": { "type": "integer", "default": 2, "min": 1, "max": 8 },
        "kind": { "type": "integer", "default": 0, "values": ["noise", "turbulence"] } },
        "nodes": { "n": { "type": "perlin_noise", "inputs": {
            "octaves": { "interface": "octaves" }, "kind": { "interface": "kind" } } } },
        "roots": { "material": { "node": "n" } } }"#;
    ("pattern.json", text.to_owned())
}

/// What uses it with these inputs.
fn patterned(inputs: &str) -> Vec<(&'static str, String)> {
    let text = format!(
        r#"{{ "phenomenon": "user", "interface": {{
            "any": {{ "type": "integer", "default": 2 }},
            "few": {{ "type": "integer", "default": 2, "min": 1, "max": 4 }} }},
            "nodes": {{ "s": {{ "type": "state" }},
                "p": {{ "type": {{ "file": "pattern.json" }}, "inputs": {{ {inputs} }} }} }},
            "roots": {{ "material": {{ "node": "p" }} }} }}"#
    );
    vec![("user.json", text), pattern()]
}

#[test]
fn what_is_known_before_shading_is_so_from_outside() {
    let of = |inputs: &str| {
        let checked = check(&patterned(inputs));
        let findings = checked.findings.iter().map(|finding| finding.code);
        let unused = [Code::UNUSED_PARAMETER, Code::UNREACHABLE_NODE];
        findings.filter(|code| !unused.contains(code)).collect::<Vec<_>>()
    };
    assert_eq!(of(r#""octaves": 4, "kind": "turbulence""#), []);
    assert_eq!(of(r#""octaves": { "interface": "few" }"#), []);
    assert_eq!(of(r#""octaves": { "interface": "any" }"#), [Code::FIXED_INPUT]);
    assert_eq!(of(r#""octaves": { "node": "s", "output": "ray_type" }"#), [Code::FIXED_INPUT]);
    assert_eq!(of(r#""octaves": 9"#), [Code::NUMBER_OUT_OF_RANGE]);
    assert_eq!(of(r#""kind": "cells""#), [Code::UNKNOWN_CHOICE]);
    assert_eq!(of(r#""kind": true, "octaves": "two""#), [Code::TYPE_MISMATCH; 2]);
}
