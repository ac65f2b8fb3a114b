//! `phenomenon check --format sarif` suits the schema of SARIF 2.1.0, and what no schema can say.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// The log of checking `paths` from the folder above.
fn log(paths: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_phenomenon"))
        .args(["check", "--format", "sarif"])
        .args(paths)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .output()
        .unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

fn validator() -> jsonschema::Validator {
    // The pattern of languages has a bracket too many, which later errata of the standard mend.
    let text = include_str!("sarif-schema-2.1.0.json");
    let mended = text.replace("{2}|^[a-zA-Z]{2}-[a-zA-Z]{2}]?$", "{2}(-[a-zA-Z]{2})?$");
    assert_ne!(text, mended);
    let schema = serde_json::from_str(&mended).unwrap();
    jsonschema::options().should_validate_formats(true).build(&schema).unwrap()
}

#[track_caller]
fn results(log: &Value) -> &Vec<Value> {
    let validator = validator();
    let mistakes: Vec<String> = validator
        .iter_errors(log)
        .map(|mistake| format!("{}: {mistake}", mistake.instance_path()))
        .collect();
    assert!(mistakes.is_empty(), "{}", mistakes.join("\n"));
    log["runs"][0]["results"].as_array().unwrap()
}

#[test]
fn logs_of_every_broken_file_suit_the_schema() {
    let log = log(&["graphs/broken"]);
    let results = results(&log);
    assert!(results.len() >= 60, "{}", results.len());
    let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
    let mut fixes = 0;
    let mut related = 0;
    for result in results {
        let rule = result["ruleIndex"].as_u64().unwrap() as usize;
        assert_eq!(rules[rule]["id"], result["ruleId"]);
        let place = &result["locations"][0]["physicalLocation"];
        let uri = place["artifactLocation"]["uri"].as_str().unwrap();
        assert!(uri.starts_with("graphs/broken/") && uri.ends_with(".json"), "{uri}");
        in_order(&place["region"]);
        for fix in result["fixes"].as_array().into_iter().flatten() {
            fixes += 1;
            let change = &fix["artifactChanges"][0];
            assert_eq!(change["artifactLocation"]["uri"], uri);
            assert_eq!(change["replacements"][0]["deletedRegion"], place["region"]);
        }
        for other in result["relatedLocations"].as_array().into_iter().flatten() {
            related += 1;
            in_order(&other["physicalLocation"]["region"]);
        }
    }
    assert!(fixes > 5 && related > 5, "{fixes} fixes, {related} other places");
}

/// A region ends where it starts or after, and counts from 1.
fn in_order(region: &Value) {
    let number = |key: &str| region[key].as_u64().unwrap();
    let start = (number("startLine"), number("startColumn"));
    assert!(start.0 >= 1 && start.1 >= 1);
    assert!(start <= (number("endLine"), number("endColumn")), "{region}");
}

#[test]
fn logs_of_good_scenes_and_missing_files_suit_the_schema() {
    assert!(results(&log(&["graphs/glass", "graphs/mirror", "scenes"])).is_empty());
    let missing = log(&["no/such/fi le é.json"]);
    let results = results(&missing);
    assert_eq!(results.len(), 1);
    let place = &results[0]["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "no/such/fi%20le%20%C3%A9.json");
}

#[test]
fn the_schema_is_looked_at() {
    let validator = validator();
    let good = log(&["graphs/broken/cycle_nothing_reaches.json"]);
    assert!(validator.is_valid(&good));
    let spoil = |pointer: &str, value: Value| {
        let mut log = good.clone();
        *log.pointer_mut(pointer).unwrap() = value;
        assert!(!validator.is_valid(&log), "{pointer}");
    };
    spoil("/version", "2.0.0".into());
    spoil("/runs", Value::Null);
    spoil("/runs/0/columnKind", "bytes".into());
    spoil("/runs/0/tool/driver/name", 1.into());
    spoil("/runs/0/results/0/level", "fatal".into());
    spoil("/runs/0/results/0/message", serde_json::json!({}));
    spoil("/runs/0/results/0/locations/0/physicalLocation/region/startLine", 0.into());
    spoil(
        "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri",
        "not a uri %".into(),
    );
}
