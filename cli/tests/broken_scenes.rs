//! Every scene in `graphs/broken/scenes` has the findings written beside it, one for each mistake.
//!
//! `PHENOMENON_BLESS=1 cargo test --workspace --test broken_scenes` writes the expected reports anew;
//! read what changed before committing it.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/broken/scenes")
}

fn phenomenon(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_phenomenon"));
    // Files are named without a folder in the reports, wherever the tests run.
    command.args(arguments).current_dir(folder()).output().unwrap()
}

fn findings(name: &str) -> Vec<Value> {
    let output = phenomenon(&["check", "--format", "json", name]);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let findings = report["findings"].as_array().unwrap().clone();
    let wrong = findings.iter().any(|finding| finding["severity"] == "error");
    assert_eq!(output.status.code(), Some(i32::from(wrong)), "{name}");
    findings
}

fn text<'v>(value: &'v Value, key: &str) -> &'v str {
    value[key].as_str().unwrap_or_else(|| panic!("no `{key}` in {value}"))
}

/// A place, with its file where that is not the scene.
fn place(value: &Value, scene: &str) -> String {
    let file = text(value, "file");
    let file = if file == scene { String::new() } else { format!("{file}:") };
    format!("{file}{}:{}", value["line"], value["column"])
}

fn report(findings: &[Value], scene: &str) -> String {
    let mut report = String::new();
    for finding in findings {
        let [code, severity, message, help, path] =
            ["code", "severity", "message", "help", "path"].map(|key| text(finding, key));
        let at = place(finding, scene);
        writeln!(report, "{at} +{} {code} {severity}: {message}", finding["length"]).unwrap();
        writeln!(report, "  at: {path}\n  help: {help}").unwrap();
        for related in finding["related"].as_array().unwrap() {
            writeln!(report, "  see {} {}", place(related, scene), text(related, "message"))
                .unwrap();
        }
    }
    report
}

fn scenes() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".json"))
        .collect();
    names.sort();
    names
}

#[test]
fn broken_scenes_have_their_expected_reports() {
    let bless = std::env::var_os("PHENOMENON_BLESS").is_some();
    let scenes = scenes();
    assert!(scenes.len() >= 50, "{} scenes", scenes.len());
    let mut wrong = Vec::new();
    for scene in &scenes {
        let findings = findings(scene);
        let report = report(&findings, scene);
        if !scene.starts_with("mixed_") && findings.len() != 1 {
            wrong.push(format!("{scene}: {} findings\n{report}", findings.len()));
        }
        let expected = folder().join(scene).with_extension("expected");
        if bless {
            std::fs::write(&expected, &report).unwrap();
        } else if std::fs::read_to_string(&expected).unwrap_or_default() != report {
            wrong.push(format!("{scene}: the report differs from what is expected:\n{report}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What a schema can say: kinds and keys, not what names refer to.
#[test]
fn structural_mistakes_do_not_suit_the_schema() {
    let path = folder().join("../../schema.json");
    let schema = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let schema = jsonschema::draft7::new(&schema).unwrap();
    let mut structural = 0;
    for scene in scenes() {
        let is_structural = |finding: &Value| {
            ["wrong-kind", "unknown-key", "missing-key"].contains(&text(finding, "code"))
        };
        if findings(&scene).iter().any(is_structural) {
            let file = std::fs::read_to_string(folder().join(&scene)).unwrap();
            let file = serde_json::from_str(&file).unwrap();
            structural += 1;
            assert!(!schema.is_valid(&file), "{scene}");
        }
    }
    assert!(structural >= 12, "{structural}");
}

/// What `check` finds an error, `render` refuses, in the same words.
#[test]
fn what_check_finds_render_refuses() {
    for scene in scenes() {
        let found = findings(&scene);
        let Some(error) = found.iter().find(|finding| finding["severity"] == "error") else {
            continue;
        };
        // Rendered black where nothing is called; only `check` says it.
        if error["code"] == "missing-root" {
            continue;
        }
        let (folder, size) = (tempfile::tempdir().unwrap(), ["--size", "1x1", "--spp", "1"]);
        let picture = folder.path().join("a.png").to_str().unwrap().to_owned();
        let output = phenomenon(&[&["render", &scene, "-o", &picture], &size[..]].concat());
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        let code = format!("error[{}]", text(error, "code"));
        assert!(told.contains(&code), "{scene}: {told}");
        assert_eq!(output.status.code(), Some(2), "{scene}: {told}");
    }
}
