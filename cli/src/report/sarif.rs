//! Findings as SARIF 2.1.0, the format of code scanning services.

use phenomenon_compiler::diagnostics::{Explanation, Finding, Place, Severity};
use serde_json::{Value, json};

use super::shown::Report;
use crate::uri;

/// One run of one tool, whose rules are all codes there are.
pub fn text(report: &Report) -> String {
    let results: Vec<Value> = report.shown.iter().map(result).collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "phenomenon",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules(),
            } },
            "columnKind": "unicodeCodePoints",
            "results": results,
            "properties": { "omitted": report.omitted },
        }],
    });
    format!("{log:#}\n")
}

fn rules() -> Vec<Value> {
    let rule = |explanation: &Explanation| {
        json!({
            "id": explanation.code.0,
            "shortDescription": { "text": explanation.title },
            "fullDescription": { "text": explanation.story },
            "help": { "text": explanation.story },
            "defaultConfiguration": { "level": level(explanation.severity) },
        })
    };
    Explanation::ALL.iter().map(rule).collect()
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

fn result(finding: &Finding) -> Value {
    let text = match finding.help.as_str() {
        "" => finding.message.clone(),
        help => format!("{}\nhelp: {help}", finding.message),
    };
    let mut location = location(&finding.place);
    if !finding.place.path.is_empty() {
        location["logicalLocations"] = json!([{ "fullyQualifiedName": finding.place.path }]);
    }
    let mut result = json!({
        "ruleId": finding.code.0,
        "level": level(finding.severity),
        "message": { "text": text },
        "locations": [location],
    });
    let rule = Explanation::ALL.iter().position(|explanation| explanation.code == finding.code);
    if let Some(rule) = rule {
        result["ruleIndex"] = json!(rule);
    }
    if !finding.related.is_empty() {
        let related = finding.related.iter().enumerate().map(|(at, related)| {
            let mut location = self::location(&related.place);
            location["id"] = json!(at);
            location["message"] = json!({ "text": related.message });
            location
        });
        result["relatedLocations"] = Value::Array(related.collect());
    }
    if let Some(fix) = &finding.fix {
        result["fixes"] = json!([{
            "description": { "text": finding.help },
            "artifactChanges": [{
                "artifactLocation": { "uri": uri(&finding.place.file.name) },
                "replacements": [{
                    "deletedRegion": region(&finding.place),
                    "insertedContent": { "text": fix },
                }],
            }],
        }]);
    }
    result
}

fn location(place: &Place) -> Value {
    json!({ "physicalLocation": {
        "artifactLocation": { "uri": uri(&place.file.name) },
        "region": region(place),
    } })
}

fn region(place: &Place) -> Value {
    let (line, column) = place.line_column();
    let (end_line, end_column) = place.end_line_column();
    json!({
        "startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column,
    })
}

/// A path as a relative URI reference: what is not plain is percent-encoded, byte by byte.
fn uri(path: &str) -> String {
    uri::escaped(path.replace('\\', "/").as_bytes())
}
