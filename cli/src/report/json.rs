//! Findings as JSON, version 1. Keys are only ever added.

use phenomenon_compiler::diagnostics::{Finding, Place};
use serde_json::{Value, json};

use super::shown::Report;

/// `{"version":1,"findings":[…],"omitted":N}`.
pub fn text(report: &Report) -> String {
    let findings: Vec<Value> = report.shown.iter().map(finding).collect();
    let report = json!({ "version": 1, "findings": findings, "omitted": report.omitted });
    format!("{report:#}\n")
}

fn finding(finding: &Finding) -> Value {
    let mut object = json!({
        "code": finding.code.0,
        "severity": finding.severity.to_string(),
        "message": finding.message,
        "help": finding.help,
    });
    merge(&mut object, place(&finding.place));
    let related = finding.related.iter().map(|related| {
        let mut object = json!({ "message": related.message });
        merge(&mut object, place(&related.place));
        object
    });
    merge(&mut object, json!({ "related": related.collect::<Vec<Value>>() }));
    object
}

fn place(place: &Place) -> Value {
    let (line, column) = place.line_column();
    json!({
        "file": place.file.name,
        "line": line,
        "column": column,
        "length": place.length(),
        "path": place.path,
    })
}

fn merge(into: &mut Value, from: Value) {
    if let (Value::Object(into), Value::Object(from)) = (into, from) {
        into.extend(from);
    }
}
