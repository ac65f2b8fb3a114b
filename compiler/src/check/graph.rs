//! The checker as a whole.

use std::path::Path;

use crate::diagnostics::{Finding, Findings};
use crate::document::{Document, Reader, all_mistakes, read_file};
use crate::graph::Graph;
use crate::nodes::NodeLibrary;

use super::files::{Files, OnDisk};
use super::nest::Nest;
use super::phenomenon;

/// What checking a graph yields.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// The graph; none when a finding is an error.
    pub graph: Option<Graph>,
    /// What was found, in file order.
    pub findings: Vec<Finding>,
    /// How many more findings there are, past [`crate::diagnostics::KEPT_FINDINGS`].
    pub omitted: usize,
}

impl Checked {
    fn from(findings: Findings, graph: Option<Graph>) -> Self {
        let graph = if findings.has_errors() { None } else { graph };
        Self { graph, omitted: findings.omitted(), findings: findings.into_sorted() }
    }
}

/// Reads a graph file and checks it. Of a file that is no JSON nothing but that is told.
pub fn read_graph_file(path: &Path, library: &NodeLibrary) -> Checked {
    match read_file(path) {
        Ok(document) => check_graph(&document, library),
        Err(finding) => Checked { findings: all_mistakes(*finding), ..Checked::default() },
    }
}

/// Checks a document that holds a phenomenon. All its mistakes are found in one run. Phenomena it
/// uses are read from disk, relative to the folder of the document's file.
pub fn check_graph(document: &Document, library: &NodeLibrary) -> Checked {
    check_graph_with(document, library, &OnDisk)
}

/// The same with the files it uses from elsewhere.
pub fn check_graph_with(document: &Document, library: &NodeLibrary, files: &dyn Files) -> Checked {
    let mut nest = Nest::new(library, files, document);
    let mut reader = Reader::new(document);
    let graph = phenomenon::check(&mut reader, &mut nest).map(|checked| checked.graph);
    // What is wrong in the files it uses follows what is wrong in itself.
    for finding in nest.into_findings() {
        reader.findings.push(finding);
    }
    Checked::from(reader.findings, graph)
}
