//! What `check` finds in every file, broken ones included.

use serde_json::Value;

use crate::files;
use crate::ledger::{Ledger, checksum};
use crate::program::run;

/// What is found in these files: how many, how the program ended, and the checksum of the report.
fn found(paths: &[&str]) -> String {
    let run = run(&[&["check", "--format", "json"], paths].concat());
    let report: Value = serde_json::from_str(&run.output)
        .unwrap_or_else(|error| panic!("{paths:?}: {error}\n{run:?}"));
    let folder = std::fs::canonicalize(crate::program::ROOT).unwrap();
    assert!(!run.output.contains(folder.to_str().unwrap()), "an absolute path: {}", run.output);
    let count = report["findings"].as_array().expect("a report has findings").len();
    let findings = if count == 1 { "finding" } else { "findings" };
    format!("{count} {findings}, exit code {}, {}", run.code, checksum(run.output.bytes()))
}

#[test]
fn findings_stay_word_for_word_and_in_order() {
    let mut ledger = Ledger::default();
    for file in [files::graphs(), files::scenes(), files::broken()].concat() {
        let found = found(&[&file]);
        ledger.add(file, found);
    }
    // The order across files, and what is said once for all of them.
    ledger.add("graphs scenes".to_owned(), found(&["graphs", "scenes"]));
    ledger.hold("findings.txt");
}
