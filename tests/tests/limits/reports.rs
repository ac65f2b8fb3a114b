//! How much is told of a file: what is past it is counted, or told with fewer words.

use std::path::Path;

use phenomenon_compiler::check::{Checked, MAX_ADVISED, MAX_CYCLE_SHOWN, OnDisk};
use phenomenon_compiler::diagnostics::{Finding, KEPT_FINDINGS, SHOWN_FINDINGS};
use phenomenon_compiler::document::{MAX_BRACKETS, MAX_MISTAKES, all_mistakes, read};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::check_with_graphs;
use phenomenon_runtime::scene_file::{Assets, MAX_UNKNOWN_LIGHTS};

use super::{CAMERA, Limit, check, code, limit, phenomenon};

pub const LIMITS: [Limit; 7] = [
    limit("findings kept for a file", KEPT_FINDINGS as u64, "a number", many_findings),
    limit("findings in a report of `check`", SHOWN_FINDINGS as u64, "a number", shown_findings),
    limit(
        "mistakes in a file that is no JSON",
        MAX_MISTAKES as u64,
        "the first are told",
        many_mistakes,
    ),
    limit(
        "brackets that are matched to tell which is missing",
        MAX_BRACKETS as u64,
        "`syntax` where it first shows",
        many_brackets,
    ),
    limit("nodes named of a cycle", MAX_CYCLE_SHOWN as u64, "the number of nodes", long_cycle),
    limit(
        "names a scene sets that its graph has not, compared with those it has",
        MAX_ADVISED as u64,
        "no name is advised",
        many_strangers,
    ),
    limit(
        "lights a graph asks for that its scene has not",
        MAX_UNKNOWN_LIGHTS as u64,
        "the first are told",
        many_lights,
    ),
];

/// A file with that many mistakes.
fn mistakes(count: usize) -> Checked {
    let inputs: Vec<String> = (0..count).map(|at| format!(r#""input_{at}":0"#)).collect();
    let node = format!(r#""n":{{"type":"mix","inputs":{{{}}}}}"#, inputs.join(","));
    check(&phenomenon(&node, r#"{"node":"n"}"#))
}

fn many_findings(_: &Path) -> String {
    let checked = mistakes(KEPT_FINDINGS);
    assert_eq!((checked.findings.len(), checked.omitted), (KEPT_FINDINGS, 0));
    let checked = mistakes(KEPT_FINDINGS + 7);
    assert_eq!((checked.findings.len(), checked.omitted), (KEPT_FINDINGS, 7));
    "a number".to_owned()
}

/// `cli/tests/check.rs` counts what is shown; here only that there can be more of them.
fn shown_findings(_: &Path) -> String {
    assert!(mistakes(SHOWN_FINDINGS + 1).findings.len() > SHOWN_FINDINGS);
    "a number".to_owned()
}

fn long_cycle(_: &Path) -> String {
    let with = |length: usize| {
        let node = |at: usize| {
            let next = (at + 1) % length;
            format!(r#""n{at}":{{"type":"add","inputs":{{"a":{{"node":"n{next}"}}}}}}"#)
        };
        let nodes: Vec<String> = (0..length).map(node).collect();
        let checked = check(&phenomenon(&nodes.join(","), r#"{"node":"n0"}"#));
        assert_eq!(code(&checked), "`cycle`");
        // The first node is named again at the end.
        (checked.findings[0].message.matches("`n").count() - 1, checked.findings[0].message.clone())
    };
    assert_eq!(with(MAX_CYCLE_SHOWN).0, MAX_CYCLE_SHOWN);
    let (named, message) = with(MAX_CYCLE_SHOWN + 1);
    assert_eq!(named, MAX_CYCLE_SHOWN);
    assert!(message.starts_with(&format!("{} nodes", MAX_CYCLE_SHOWN + 1)), "{message}");
    "the number of nodes".to_owned()
}

/// What is wrong in a text that is no JSON.
fn mistakes_of(text: &str) -> Vec<Finding> {
    all_mistakes(*read("limit.json", text.as_bytes()).unwrap_err())
}

fn many_mistakes(_: &Path) -> String {
    let with = |count: usize| {
        mistakes_of(&format!(r#"{{"phenomenon":"p","editor":[{}]}}"#, vec![".5"; count].join(",")))
            .len()
    };
    assert_eq!(with(MAX_MISTAKES), MAX_MISTAKES);
    assert_eq!(with(MAX_MISTAKES + 7), MAX_MISTAKES);
    "the first are told".to_owned()
}

fn many_brackets(_: &Path) -> String {
    // Those of the file, of the list that is not closed, and of the roots.
    let with = |brackets: usize| {
        let lists = vec!["[]"; (brackets - 5) / 2].join(",\n    ");
        let text =
            format!("{{ \"editor\": [\n    {lists}\n  ,\n  \"roots\": {{ \"material\": 1 }} }}");
        let mistakes = mistakes_of(&text);
        let [mistake] = mistakes.as_slice() else { panic!("{mistakes:?}") };
        mistake.clone()
    };
    assert!(with(MAX_BRACKETS).message.contains("`editor` is never closed"));
    let past = with(MAX_BRACKETS + 2);
    assert!(past.message.contains("`:` has no place here"), "{past}");
    format!("`{}` where it first shows", past.code)
}

/// What is wrong in a scene with one sphere, shaded by that graph with those settings.
fn shaded(folder: &Path, graph: &str, set: &str) -> Vec<Finding> {
    std::fs::write(folder.join("graph.json"), graph).unwrap();
    let material = format!(r#"{{"file":"graph.json","set":{{{set}}}}}"#);
    let object = format!(r#"{{"sphere":{{"radius":1}},"material":{material}}}"#);
    let text = format!(r#"{{"scene":"s",{CAMERA},"objects":[{object}]}}"#);
    let document = read("scene.json", text.as_bytes()).unwrap();
    let library = NodeLibrary::standard();
    check_with_graphs(&document, folder, &library, &OnDisk, &Assets::default()).findings
}

fn many_strangers(folder: &Path) -> String {
    let graph = r#"{"phenomenon":"p","interface":{"tint":{"type":"color","default":1}},"roots":{"material":{"interface":"tint"}}}"#;
    let set: Vec<String> = (0..=MAX_ADVISED).map(|at| format!(r#""tint_{at}":1"#)).collect();
    let found = shaded(folder, graph, &set.join(","));
    let (last, advised) = found.split_last().unwrap();
    assert_eq!(advised.len(), MAX_ADVISED);
    assert!(advised.iter().all(|finding| finding.help.contains("`tint`")), "{}", advised[0]);
    assert!(last.help.contains("so many are unknown"), "{last}");
    "no name is advised".to_owned()
}

fn many_lights(folder: &Path) -> String {
    let with = |count: usize| {
        let lights: Vec<String> = (0..count).map(|at| format!(r#"{{"light":"l{at}"}}"#)).collect();
        let inputs = format!(r#"{{"body":{{"node":"b"}},"lights":[{}]}}"#, lights.join(","));
        let nodes =
            format!(r#""b":{{"type":"lambert"}},"n":{{"type":"light_loop","inputs":{inputs}}}"#);
        shaded(folder, &phenomenon(&nodes, r#"{"node":"n"}"#), "").len()
    };
    assert_eq!(with(MAX_UNKNOWN_LIGHTS), MAX_UNKNOWN_LIGHTS);
    assert_eq!(with(MAX_UNKNOWN_LIGHTS + 1), MAX_UNKNOWN_LIGHTS);
    "the first are told".to_owned()
}
