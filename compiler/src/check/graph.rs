//! The checker as a whole.

use std::borrow::Cow;
use std::path::Path;
use std::rc::Rc;

use crate::diagnostics::{Finding, Findings};
use crate::document::{Document, Reader, all_mistakes, read_file};
use crate::graph::Graph;
use crate::nodes::{NodeLibrary, Signature};

use super::expressions;
use super::files::{Files, OnDisk};
use super::nested::Nested;
use super::phenomenon::{self, Given};
use super::reachable::{Content, Named, Reachable, Reached};
use super::turns::unroll;

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

/// The same with the files it uses from elsewhere. All it reaches are checked, those first that name no
/// other.
pub fn check_graph_with(document: &Document, library: &NodeLibrary, files: &dyn Files) -> Checked {
    let (document, repeats) = &written_out(document, library);
    let mut reachable = Reachable::from(document, library, files);
    let mut checked: Vec<Option<Rc<Nested>>> = Vec::new();
    let mut found = Findings::default();
    while let Some(Reached { content, uses }) = reachable.next() {
        let given = Given { library, files, checked: &checked, written: &[] };
        let (findings, phenomenon) = match content {
            Content::Mistakes(findings) => (findings, None),
            Content::Document(document, repeats, named) => {
                check_one((&document, &repeats), given, named)
            }
        };
        for finding in findings {
            // Texts of uses cost more than the finding, where there are too many to be shown.
            let is_full = found.is_full();
            found.push(if is_full { finding } else { uses.told_with(finding) });
        }
        checked.push(phenomenon.map(Rc::new));
    }
    let written = expressions::room(&document.root);
    let mut reader = reader_of(document, repeats);
    let given = Given { library, files, checked: &checked, written: &written };
    let mut named = reachable.into_named();
    let phenomenon = phenomenon::check(&mut reader, given, &mut named);
    // What is wrong in the files it uses follows what is wrong in itself.
    for finding in found.into_sorted() {
        reader.findings.push(finding);
    }
    Checked::from(reader.findings, phenomenon.map(|phenomenon| phenomenon.graph))
}

/// What a phenomenon is where it is a node, under that name: its parameters, and what it offers.
pub fn as_node(graph: &Graph, name: &str) -> Signature {
    let nested = Nested::new(graph.clone(), 1, Vec::new(), Vec::new());
    nested.definition(name.to_owned()).signature
}

/// A document with its maps and folds written out, and what is wrong with those.
pub(super) fn written_out<'d>(
    document: &'d Document,
    library: &NodeLibrary,
) -> (Cow<'d, Document>, Vec<Finding>) {
    match unroll(document, library) {
        Some((document, findings)) => (Cow::Owned(document), findings),
        None => (Cow::Borrowed(document), Vec::new()),
    }
}

/// A reader of a document that was written out so.
fn reader_of<'d>(document: &'d Document, repeats: &[Finding]) -> Reader<'d> {
    let mut reader = Reader::new(document);
    if document.written.is_some() {
        reader.findings.tell_once();
    }
    repeats.iter().for_each(|finding| reader.findings.push(finding.clone()));
    reader
}

/// The findings of a file that another uses, and the phenomenon it is if it is right.
fn check_one(
    (document, repeats): (&Document, &[Finding]),
    given: Given<'_>,
    mut named: Named,
) -> (Vec<Finding>, Option<Nested>) {
    let written = expressions::room(&document.root);
    let mut reader = reader_of(document, repeats);
    let given = Given { written: &written, ..given };
    let phenomenon = phenomenon::check(&mut reader, given, &mut named);
    let phenomenon = phenomenon.filter(|_| !reader.findings.has_errors());
    (reader.findings.into_sorted(), phenomenon)
}
