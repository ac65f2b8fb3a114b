//! Every graph that is shipped is checked without a finding, and every file is in canonical form.

use std::path::{Path, PathBuf};

use phenomenon_compiler::check::read_graph_file;
use phenomenon_compiler::document::{canonical, read_file};
use phenomenon_compiler::nodes::NodeLibrary;

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("broken") {
            files(&path, found);
        } else if path.extension().is_some_and(|it| it == "json") && !path.ends_with("schema.json")
        {
            found.push(path);
        }
    }
}

#[test]
fn shipped_graphs_have_no_findings() {
    let mut paths = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../graphs"), &mut paths);
    assert!(paths.len() >= 5, "{paths:?}");
    let library = NodeLibrary::standard();
    for path in paths {
        let checked = read_graph_file(&path, &library);
        let text: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
        assert!(text.is_empty(), "{}", text.join("\n"));
        assert!(checked.graph.is_some());
    }
}

/// `phenomenon fmt graphs/*/*.json scenes/*.json` writes them so, as does this test with
/// `PHENOMENON_BLESS=1`. Files in `graphs/broken` stay as their mistakes were made.
#[test]
fn shipped_files_are_in_canonical_form() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    files(&root.join("graphs"), &mut paths);
    let graphs = paths.len();
    files(&root.join("scenes"), &mut paths);
    assert!(graphs >= 7 && paths.len() >= graphs + 2, "{paths:?}");
    for path in paths {
        let document = read_file(&path).unwrap();
        let form = canonical(&document);
        if std::env::var_os("PHENOMENON_BLESS").is_some() {
            if form != document.file.text {
                std::fs::write(&path, &form).unwrap();
            }
        } else {
            assert!(form == document.file.text, "run `phenomenon fmt {}`", path.display());
        }
    }
}
