//! Every file in `graphs/broken` has the findings written beside it, one for each mistake.
//!
//! `PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler --test check_broken` writes the expected
//! reports anew; read what changed before committing it.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::Finding;
use phenomenon_compiler::document::{all_mistakes, read};
use phenomenon_compiler::nodes::NodeLibrary;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs/broken")
}

fn report(findings: &[Finding]) -> String {
    let mut text = String::new();
    for finding in findings {
        let Finding { code, severity, message, help, place, related, fix } = finding;
        let (line, column) = place.line_column();
        let path = &place.path;
        writeln!(text, "{line}:{column} +{} {code} {severity}: {message}", place.length()).unwrap();
        writeln!(text, "  at: {path}").unwrap();
        writeln!(text, "  help: {help}").unwrap();
        for related in related {
            let (line, column) = related.place.line_column();
            writeln!(text, "  see {line}:{column} {}", related.message).unwrap();
        }
        if let Some(fix) = fix {
            writeln!(text, "  fix: {fix}").unwrap();
        }
    }
    text
}

fn check(path: &Path, library: &NodeLibrary) -> Checked {
    let bytes = std::fs::read(path).unwrap();
    match read(&path.file_name().unwrap().to_string_lossy(), &bytes) {
        Ok(document) => check_graph(&document, library),
        Err(finding) => Checked { findings: all_mistakes(*finding), ..Checked::default() },
    }
}

#[test]
fn broken_files_have_their_expected_reports() {
    let bless = std::env::var_os("PHENOMENON_BLESS").is_some();
    let library = NodeLibrary::standard();
    // Files are named without a folder in the reports, wherever the tests run.
    std::env::set_current_dir(folder()).unwrap();
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    assert!(files.len() >= 60, "{} files", files.len());
    let mut wrong = Vec::new();
    for path in &files {
        let checked = check(path, &library);
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if !name.starts_with("mixed_") && checked.findings.len() != 1 {
            wrong.push(format!(
                "{name}: {} findings\n{}",
                checked.findings.len(),
                report(&checked.findings)
            ));
        }
        let expected = path.with_extension("expected");
        let report = report(&checked.findings);
        if bless {
            std::fs::write(&expected, &report).unwrap();
        } else if std::fs::read_to_string(&expected).unwrap_or_default() != report {
            wrong
                .push(format!("{name}: the report differs from {}:\n{report}", expected.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A mistake, what MaterialX's validator says to it, and the file here that has it.
const COMPARISON: [(&str, &str, &str); 14] = [
    (
        "a value of the wrong type",
        "\"Mismatched types in port connection\", the tag",
        "color_into_scalar",
    ),
    ("an unknown node type", "valid", "unknown_node_type"),
    ("an unknown input", "\"doesn't match declaration\", no suggestion", "unknown_input"),
    (
        "a cycle above an output",
        "\"Cycle in upstream path\", no path",
        "cycle_of_three_with_a_tail",
    ),
    ("a cycle that reaches nothing", "valid", "cycle_nothing_reaches"),
    ("a missing output", "\"Invalid port connection\"", "unknown_output"),
    ("an input with no value", "reported", "missing_input"),
    ("a duplicate name", "valid, the second node dropped", "duplicate_node"),
    ("a word that is not in the enumeration", "valid", "unknown_enumeration_value"),
    ("a value out of range", "valid", "literal_out_of_range"),
    ("an unused node", "valid", "unreachable_node"),
    ("a number that is not finite", "not tried", "infinite_number"),
    ("a syntax error", "a Python traceback with a character offset", "syntax_missing_comma"),
    ("four mistakes in one file", "two of them", "mixed_four_mistakes"),
];

/// Figures of one run on a machine with two cores that had other work too.
const SPEED: &str = "
## Speed

`cargo bench -p phenomenon-compiler --bench check` reads and checks chains of sums, and has serde_json parse the same \
bytes as a baseline. CPU milliseconds, the best of many runs:

| nodes | kilobytes | read | read and check | per node, µs | serde_json | ratio |
| ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| 1000 | 62 | 3.15 | 7.33 | 7.33 | 2.09 | 3.5 |
| 4000 | 254 | 10.14 | 25.51 | 6.38 | 6.54 | 3.9 |
| 20000 | 1298 | 65.11 | 278.03 | 13.90 | 68.87 | 4.0 |
| 100000 | 6578 | 493.99 | 1438.42 | 14.38 | 275.33 | 5.2 |

A node costs twice as much in a file of megabytes as in a small one, because its memory no longer fits the cache; it \
does so for serde_json too. The machine is shared: the same program took 23 to 51 ms for 4,000 nodes within an hour, and \
serde_json 6 to 13, so the ratio says more. A test holds the time to a line: `compiler/tests/check_hostile.rs`.
";

/// `PHENOMENON_BLESS=1` writes it anew, like the reports.
#[test]
fn the_comparison_is_in_sync() {
    let library = NodeLibrary::standard();
    let mut page = String::from(
        "# Validation compared\n\n\
         What `phenomenon check` says to files of `graphs/broken`, beside what MaterialX's \
         `mxvalidate` says to documents with the same mistake. The right column is written by a test. \
         `mxvalidate` names no line, no column and no severity, and exits with 0 for all but the syntax \
         error; `phenomenon check` exits with 1 where there is an error.\n\n\
         | mistake | mxvalidate | phenomenon check |\n| --- | --- | --- |\n",
    );
    for (mistake, other, name) in COMPARISON {
        let checked = check(&folder().join(format!("{name}.json")), &library);
        let ours: Vec<String> = checked
            .findings
            .iter()
            .map(|finding| {
                let (line, column) = finding.place.line_column();
                let help = if finding.fix.is_some() {
                    format!("; {}", finding.help)
                } else {
                    String::new()
                };
                format!("{line}:{column} {}: {}{help}", finding.severity, finding.message)
            })
            .collect();
        assert!(!ours.is_empty(), "{name}");
        writeln!(page, "| {mistake} | {other} | {} |", ours.join("<br>").replace('|', "\\|"))
            .unwrap();
    }
    page.push_str(SPEED);
    let path = folder().join("../../docs/validation.md");
    if std::env::var_os("PHENOMENON_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    assert!(
        std::fs::read_to_string(&path).unwrap_or_default() == page,
        "docs/validation.md differs:\n{page}"
    );
}
