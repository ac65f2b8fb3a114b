//! `phenomenon check`; what it finds is tested with the checker.

use std::io::Write;
use std::process::Stdio;

use serde_json::Value;

use crate::program::{Folder, printed, program, refused, run};

const MISSPELT: &str = r#"{ "phenomenon": "a", "version": 1, "nodes": { "n": { "type": "lambrt" } },
  "roots": { "material": { "node": "n" } } }"#;

#[test]
fn what_is_shipped_has_no_errors() {
    let groups = ["constant", "floor", "glass", "mirror", "rainbow", "sky"];
    let folders = groups.map(|group| format!("graphs/{group}"));
    let paths: Vec<&str> = folders.iter().map(String::as_str).collect();
    printed(&[&["check"], &paths[..]].concat());
}

#[test]
fn exit_codes_tell_findings_from_failures() {
    let folder = Folder::new();
    let misspelt = folder.file("misspelt.json", MISSPELT);
    let found = run(&["check", &misspelt]);
    assert_eq!(found.code, Some(1), "{found:?}");
    assert!(found.output.contains("did you mean `lambert`?"), "{}", found.output);
    assert_eq!(run(&["check", &folder.path("absent.json")]).code, Some(2));
    assert_eq!(run(&["check", &misspelt, &folder.path("absent.json")]).code, Some(2));
    assert_eq!(run(&["check", &folder.file("empty.json", "")]).code, Some(1));
    refused(&["check"], &["<PATH>"]);
    refused(&["check", "a.json", "--format", "xml"], &["xml", "sarif"]);
    refused(&["check", "a.json", "--deny", "notes"], &["notes", "warnings"]);
}

#[test]
fn json_has_the_place_of_every_finding() {
    let folder = Folder::new();
    let misspelt = folder.file("misspelt.json", MISSPELT);
    let report = run(&["check", &misspelt, "--format", "json"]);
    let report: Value = serde_json::from_str(&report.output).unwrap();
    assert_eq!(report["version"], 1);
    let finding = &report["findings"][0];
    assert_eq!(finding["file"], misspelt.as_str());
    let place = ["line", "column", "length"].map(|key| finding[key].as_u64());
    assert_eq!(place, [Some(1), Some(62), Some(8)], "{finding}");
    for key in ["code", "severity", "message", "help", "path", "related"] {
        assert!(finding.get(key).is_some(), "{key}: {finding}");
    }
}

#[test]
fn standard_input_is_a_file_called_dash() {
    let mut command = program(&["check", "-", "--format", "json"]);
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(MISSPELT.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["findings"][0]["file"], "-");
}

#[test]
fn fixing_mends_what_is_sure() {
    let folder = Folder::new();
    let misspelt = folder.file("misspelt.json", MISSPELT.replace("lambrt", "mxi"));
    run(&["check", &misspelt, "--fix"]);
    let mended = std::fs::read_to_string(&misspelt).unwrap();
    assert_eq!(mended, MISSPELT.replace("lambrt", "mix"));
}

#[test]
fn formats_are_named_as_they_are_written() {
    let folder = Folder::new();
    for (format, said) in
        [("2", "format 2"), ("1e99", "format 1e99"), ("0", "1 to 1"), ("1.5", "whole")]
    {
        let text = format!(
            r#"{{ "format": {format}, "phenomenon": "g", "roots": {{ "material": [1, 1, 1] }} }}"#
        );
        let found = run(&["check", &folder.file("g.json", text)]);
        assert_eq!(found.code, Some(1), "{format}");
        assert!(found.output.contains(said), "{format}: {}", found.output);
    }
}

#[test]
fn a_file_is_looked_at_once_and_a_scenes_graph_told_whole() {
    let folder = Folder::new();
    let broken = folder.file(
        "g.json",
        r#"{ "phenomenon": "g", "version": 01, "roots": { "material": [.5, +1, 0] } }"#,
    );
    let again = folder.path("./g.json");
    let found = run(&["check", &broken, &again]);
    assert_eq!(found.output.matches("error[syntax]").count(), 3, "{}", found.output);
    let scene = folder.file(
        "s.json",
        r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] },
          "objects": [{ "sphere": { "radius": 1 }, "material": { "file": "g.json" } }] }"#,
    );
    let found = run(&["check", &scene]);
    assert_eq!(found.output.matches("error[syntax]").count(), 3, "{}", found.output);
    let refusal = run(&["render", &scene, "-o", &folder.path("p.png")]);
    assert_eq!(refusal.complaint.matches("error[syntax]").count(), 3, "{}", refusal.complaint);
}
