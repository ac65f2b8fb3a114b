//! Graphs that are checked, from files in memory.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::{Checked, Files, check_graph_with};
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile};
use phenomenon_compiler::document::{Document, read};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;

/// Files that exist in memory only.
struct InMemory(HashMap<PathBuf, String>);

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let name = path.display().to_string();
        match self.0.get(path) {
            Some(text) => read(&name, text.as_bytes()),
            None => {
                let file = Arc::new(SourceFile::new(name, ""));
                let place = Place { file, start: 0, end: 0, path: String::new() };
                Err(Box::new(Finding::new(Code::UNREADABLE_FILE, place, "no such file", "")))
            }
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        (!self.0.contains_key(path)).then(|| "no such file".into())
    }
}

pub fn check_files(files: &[(&str, &str)]) -> Checked {
    let texts = files.iter().map(|(name, text)| (PathBuf::from(name), (*text).to_owned()));
    let document = read(files[0].0, files[0].1.as_bytes()).unwrap();
    check_graph_with(&document, &NodeLibrary::standard(), &InMemory(texts.collect()))
}

pub fn check(text: &str) -> Checked {
    check_files(&[("a.json", text), ("wood.png", "")])
}

pub fn graph(files: &[(&str, &str)]) -> Graph {
    let checked = check_files(files);
    let findings: Vec<String> = checked.findings.iter().map(ToString::to_string).collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
    checked.graph.unwrap()
}

pub fn codes(text: &str) -> Vec<Code> {
    check(text).findings.iter().map(|finding| finding.code).collect()
}
