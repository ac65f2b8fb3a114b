//! `phenomenon bench shade`; what it prints is measured, so only its shape is known.

use serde_json::Value;

use crate::program::{Folder, refused, run};

const ENGINES: [&str; 4] = ["walk", "batch", "jit", "monolith"];

/// Names, then two figures.
const KEYS: [&str; 6] = ["workload", "batch", "engine", "precision", "ns_per_point", "spread"];

#[test]
fn rows_have_their_keys_and_ratios_their_baselines() {
    let folder = Folder::new();
    let results = folder.path("new");
    let arguments = ["--workload", "ten", "--workload", "mixed", "--runs", "2", "-o", &results];
    let run = run(&[&["bench", "shade"], &arguments[..]].concat());
    assert_eq!(run.code, Some(0), "{run:?}");
    let text = std::fs::read_to_string(folder.path("new/shade.json")).unwrap();
    let report: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(report["version"], 1);
    let rows = report["rows"].as_array().unwrap();
    // A machine without the jit says so, and has no rows of it.
    let without_jit = run.complaint.contains("without jit");
    let engines = ENGINES.iter().filter(|engine| !(without_jit && **engine == "jit"));
    let mut expected = Vec::new();
    for workload in ["ten", "mixed"] {
        for batch in [1, 16, 256] {
            for engine in engines.clone() {
                expected.push((workload.to_owned(), batch, (*engine).to_owned()));
            }
        }
    }
    let text = |row: &Value, key: &str| row[key].as_str().unwrap().to_owned();
    let found: Vec<_> = rows
        .iter()
        .map(|row| (text(row, "workload"), row["batch"].as_u64().unwrap(), text(row, "engine")))
        .collect();
    assert_eq!(found, expected);
    for row in rows {
        let keys: Vec<&String> = row.as_object().unwrap().keys().collect();
        assert_eq!(keys, KEYS);
        assert_eq!(row["precision"], "standard");
        assert!(row["ns_per_point"].as_f64().unwrap() > 0.0, "{row}");
        assert!(row["spread"].as_f64().unwrap() >= 0.0, "{row}");
    }
    // The table has the same rows, and a baseline is 1 to itself.
    let lines: Vec<&str> = run.output.lines().filter(|line| line.starts_with("| ")).collect();
    assert_eq!(lines.len(), rows.len() + 2, "{}", run.output);
    for (line, (workload, batch, engine)) in lines[2..].iter().zip(&expected) {
        let start = format!("| {workload} | {batch} | {engine} | ");
        assert!(line.starts_with(&start), "{line}");
        assert!(engine != "walk" || line.ends_with(" 1.00 |"), "{line}");
        assert!(engine != "batch" || line.contains(" | 1.00 | "), "{line}");
    }
}

#[test]
fn wrong_flags_are_refused() {
    refused(&["bench", "shade", "--workload", "tne"], &["--workload", "tne", "ten", "branchy"]);
    refused(&["bench", "shade", "--runs", "0"], &["--runs", "1 to 100"]);
    refused(&["bench", "shade", "--runs", "many"], &["--runs", "many"]);
    refused(&["bench", "shade", "graph.json"], &["graph.json"]);
    let folder = Folder::new();
    let taken = folder.file("taken", "");
    refused(&["bench", "shade", "-o", &taken], &["-o", "taken", "another folder"]);
    // Only a result takes the place of a result.
    let graph = r#"{ "phenomenon": "shade", "roots": { "material": 1 } }"#;
    let own = folder.file("shade.json", graph);
    let message = ["shade.json", "no result of `bench shade`"];
    refused(&["bench", "shade", "--runs", "1", "-o", &folder.path("")], &message);
    assert_eq!(std::fs::read_to_string(own).unwrap(), graph);
}
