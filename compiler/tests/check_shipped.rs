//! Every graph that is shipped is checked without a finding.

use std::path::{Path, PathBuf};

use phenomenon_compiler::check::read_graph_file;
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
