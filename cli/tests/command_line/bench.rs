//! `phenomenon bench shade` and `compile`; what they print is measured, so only its shape is known.

use phenomenon_compiler::engine::jit::Generator;
use phenomenon_compiler::kernels::native_simd;
use serde_json::Value;

use crate::program::{Folder, refused, run};

const ENGINES: [&str; 7] =
    ["walk", "batch", "jit", "jit_cranelift", "monolith", "monolith8", "fused8"];

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
    let is_here = |engine: &&&str| match **engine {
        "jit" => Generator::chosen(None).is_ok(),
        "jit_cranelift" => Generator::Native.available().is_ok(),
        "monolith8" => native_simd(),
        _ => true,
    };
    let engines = ENGINES.iter().filter(is_here);
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
fn materials_are_shaded_from_what_was_recorded() {
    let folder = Folder::new();
    let results = folder.path("new");
    let names = ["sunglasses", "snow"];
    let arguments = ["--workload", names[0], "--workload", names[1], "--runs", "1", "-o", &results];
    let run = run(&[&["bench", "shade"], &arguments[..]].concat());
    assert_eq!(run.code, Some(0), "{run:?}");
    let text = std::fs::read_to_string(folder.path("new/shade.json")).unwrap();
    let report: Value = serde_json::from_str(&text).unwrap();
    let rows = report["rows"].as_array().unwrap();
    for name in names {
        for batch in [1, 16, 256] {
            let of = |engine: &str| {
                let is_it = |row: &&Value| {
                    row["workload"] == name && row["batch"] == batch && row["engine"] == engine
                };
                rows.iter().find(is_it)
            };
            for engine in ["walk", "batch", "monolith", "monolith_same_bits"] {
                let row = of(engine).unwrap_or_else(|| panic!("{name} lacks {engine}"));
                assert!(row["ns_per_point"].as_f64().unwrap() > 0.0, "{row}");
                let compiled = row.get("compile_ms").map(|it| it.as_f64().unwrap() > 0.0);
                assert_eq!(compiled, (!engine.starts_with("monolith")).then_some(true), "{row}");
            }
            let jit = Generator::chosen(None).is_ok();
            assert_eq!((of("jit").is_some(), of("jit_eager").is_some()), (jit, jit));
        }
    }
    // Laziness saves something in both: light from below the surface, and nodes.
    let counted = run.output.split("| material | rays").nth(1).unwrap();
    for name in names {
        let line = counted.lines().find(|line| line.starts_with(&format!("| {name} |"))).unwrap();
        let figures: Vec<f64> =
            line.split('|').filter_map(|figure| figure.trim().parse().ok()).collect();
        let [rays, all_rays, lights, all_lights, evaluations, of_all] = figures[..] else {
            panic!("{line}");
        };
        assert!(0.0 < rays && rays <= all_rays, "{line}");
        assert!(0.0 < lights && lights < all_lights, "{line}");
        assert!(0.0 < evaluations && evaluations < of_all, "{line}");
    }
}

/// Of `bench compile`: names, then milliseconds.
const STAGES: [&str; 10] = [
    "graph",
    "nodes",
    "generator",
    "check_ms",
    "specialise_ms",
    "schedule_ms",
    "record_ms",
    "generate_ms",
    "compile_ms",
    "first_batch_ms",
];

#[test]
fn compiling_is_measured_stage_by_stage() {
    let folder = Folder::new();
    let results = folder.path("new");
    let run =
        run(&["bench", "compile", "--nodes", "20", "--nodes", "40", "--runs", "2", "-o", &results]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let text = std::fs::read_to_string(folder.path("new/compile.json")).unwrap();
    let report: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(report["version"], 1);
    let rows = report["rows"].as_array().unwrap();
    let found: Vec<(&str, u64)> = rows
        .iter()
        .map(|row| (row["graph"].as_str().unwrap(), row["nodes"].as_u64().unwrap()))
        .collect();
    // Whole layers, as many as fit.
    let mut generators = Generator::ALL.to_vec();
    generators.retain(|generator| generator.available().is_ok());
    let graphs = [("ten", 19), ("light", 13), ("mixed", 19), ("light", 33), ("mixed", 35)];
    let expected: Vec<_> =
        graphs.iter().flat_map(|&graph| generators.iter().map(move |_| graph)).collect();
    assert_eq!(found, expected);
    for row in rows {
        let keys: Vec<&String> = row.as_object().unwrap().keys().collect();
        assert_eq!(keys, STAGES);
        for stage in &STAGES[3..] {
            assert!(row[stage].as_f64().unwrap() >= 0.0, "{row}");
        }
    }
    let lines: Vec<&str> = run.output.lines().filter(|line| line.starts_with("| ")).collect();
    assert_eq!(lines.len(), rows.len() + 2, "{}", run.output);
    let generators = generators.iter().cycle();
    for ((line, (graph, nodes)), generator) in lines[2..].iter().zip(expected).zip(generators) {
        assert!(
            line.starts_with(&format!("| {graph} | {nodes} | {} |", generator.name())),
            "{line}"
        );
    }
}

#[test]
fn wrong_flags_are_refused() {
    refused(&["bench", "compile", "--nodes", "0"], &["--nodes", "1 to 100000"]);
    refused(&["bench", "compile", "graph.json"], &["graph.json"]);
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
