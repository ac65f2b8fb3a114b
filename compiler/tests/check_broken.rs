//! Every file in `graphs/broken` has the findings written beside it, one for each mistake.
//!
//! `PHENOMENON_BLESS=1 cargo test -p phenomenon-compiler --test check_broken` writes the expected
//! reports anew; read what changed before committing it.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Checked, check_graph};
use phenomenon_compiler::diagnostics::Finding;
use phenomenon_compiler::document::read;
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
        Err(finding) => Checked { findings: vec![*finding], ..Checked::default() },
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
