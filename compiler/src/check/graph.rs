//! The checker as a whole.

use std::cell::Cell;
use std::collections::HashMap;
use std::path::Path;

use crate::diagnostics::{Code, Finding, Findings};
use crate::document::{Document, Reader, Value, ValueKind, all_mistakes, read_file};
use crate::graph::Graph;
use crate::nodes::NodeLibrary;

use super::draft::{Draft, Suggestions};
use super::intervals::Intervals;
use super::nested::{Files, Nest, Nested, OnDisk};
use super::{
    bind_inputs, cycles, dead_inputs, expand, hazards, interface, light_loops, nodes, ranges,
    reach, requirements, roots, stations, textures, types,
};

/// Most nodes a graph may have.
pub const MAX_NODES: usize = 1_000_000;

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

/// The keys of a phenomenon.
pub(super) const KEYS: [&str; 10] = [
    "$schema",
    "format",
    "phenomenon",
    "version",
    "doc",
    "requires",
    "interface",
    "nodes",
    "roots",
    "editor",
];

/// Checks a document that holds a phenomenon. All its mistakes are found in one run. Phenomena it
/// uses are read from disk, relative to the folder of the document's file.
pub fn check_graph(document: &Document, library: &NodeLibrary) -> Checked {
    check_graph_with(document, library, &OnDisk)
}

/// The same with the files it uses from elsewhere.
pub fn check_graph_with(document: &Document, library: &NodeLibrary, files: &dyn Files) -> Checked {
    let mut nest = Nest::new(library, files, document);
    let mut reader = Reader::new(document);
    let graph = check(&mut reader, &mut nest).map(|checked| checked.graph);
    // What is wrong in the files it uses follows what is wrong in itself.
    for finding in nest.into_findings() {
        reader.findings.push(finding);
    }
    Checked::from(reader.findings, graph)
}

/// Checks a phenomenon; the graph has no nested phenomena any more.
pub(super) fn check<'d>(reader: &mut Reader<'d>, nest: &mut Nest<'_>) -> Option<Nested> {
    let root = &reader.document.root;
    if !is_graph(reader, root) || !reader.reads_format(root) {
        return None;
    }
    let object = reader.object(root, "a phenomenon", &KEYS)?;
    let name = object.optional("phenomenon").and_then(|value| {
        let name = reader.string(value, "the name of the phenomenon")?;
        nodes::check_name(reader, value, "the name of the phenomenon", name);
        Some(name)
    });
    let version = object
        .optional("version")
        .and_then(|value| reader.integer(value, "`version`", 0..=i32::MAX));
    let doc = object.optional("doc").and_then(|value| reader.string(value, "`doc`"));
    if let Some(value) = object.optional("$schema") {
        reader.string(value, "`$schema`");
    }
    let mut draft = Draft {
        library: nest.library.clone(),
        phenomena: HashMap::new(),
        nested: HashMap::new(),
        parameters: Vec::new(),
        nodes: Vec::new(),
        roots: Vec::new(),
        parameter_names: HashMap::new(),
        values_left: Cell::new(MAX_NODES),
        part_bytes: 0,
        compounds: Vec::new(),
        compound_names: HashMap::new(),
        node_names: HashMap::new(),
        suggestions: Suggestions::default(),
        unresolved: Cell::new(reader.findings.has_errors()),
    };
    nest.load(reader, object.optional("nodes"), &mut draft);
    interface::read(reader, object.optional("interface"), &mut draft);
    nodes::read(reader, object.optional("nodes"), &mut draft)?;
    roots::read(reader, root, object.optional("roots"), &mut draft);
    let order = cycles::order(reader, &draft);
    let types = types::resolve(&draft, &order);
    let (nodes, roots) = bind_inputs::bind(reader, &draft, &types);
    let requirements = requirements::check(reader, object.optional("requires"), &draft);
    let outside_loops = light_loops::check(reader, &draft);
    stations::check(reader, &draft);
    reach::check(reader, &draft);
    let intervals = Intervals::of(&draft, &nodes, &order);
    ranges::check(reader, &draft, &intervals);
    hazards::check(reader, &draft, &intervals);
    dead_inputs::check(reader, &draft, &intervals);
    let ruled_out = intervals.ruled_out();
    textures::check(reader, nest.files());
    let graph = Graph {
        name: name.unwrap_or_default().to_owned(),
        doc: doc.unwrap_or_default().to_owned(),
        version: version.unwrap_or_default(),
        requirements,
        parameters: draft
            .parameters
            .iter_mut()
            .filter_map(|given| given.parameter.take())
            .collect(),
        nodes,
        roots,
        ruled_out,
    };
    if draft.phenomena.values().any(Option::is_none) || reader.findings.has_errors() {
        return None;
    }
    let graph = match draft.nested.is_empty() {
        true => graph,
        false => expand::expand(reader, &draft, graph)?,
    };
    let shapes = draft.compounds.drain(..).filter(|(name, _)| !name.contains(['.', '[']));
    Some(Nested::new(&draft.library, graph, outside_loops, shapes.collect()))
}

/// Whether the document is meant as a graph; a finding if not.
fn is_graph(reader: &mut Reader<'_>, root: &Value) -> bool {
    let (message, help) = match &root.kind {
        ValueKind::Object(_) if root.get("phenomenon").is_some() => return true,
        ValueKind::Object(_) if root.get("scene").is_some() => (
            "this file is a scene, not a phenomenon".to_owned(),
            "give it where a scene is wanted, or one of the materials it names here",
        ),
        ValueKind::Object(_) => (
            "a phenomenon lacks the key `phenomenon`, its name".to_owned(),
            "add `\"phenomenon\": \"name\"`",
        ),
        _ => (
            format!("a phenomenon is an object, not {}", root.describe()),
            "start with `{ \"phenomenon\": \"name\" … }`",
        ),
    };
    let place = reader.document.place_of_bytes(root.start, root.start + 1);
    reader.findings.push(Finding::new(Code::NOT_A_GRAPH, place, message, help));
    // An object that only lacks its name is still worth checking.
    matches!(root.kind, ValueKind::Object(_)) && root.get("scene").is_none()
}
