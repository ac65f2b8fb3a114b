//! The check of one phenomenon.

use std::rc::Rc;

use crate::diagnostics::{Code, Finding};
use crate::document::{Object, Reader, Value, ValueKind};
use crate::graph::{Graph, Node};
use crate::nodes::NodeLibrary;

use super::draft::Draft;
use super::files::Files;
use super::intervals::Intervals;
use super::nested::Nested;
use super::reachable::Named;
use super::{
    bind_inputs, cycles, dead_inputs, expand, hazards, interface, keys, loops, names, nodes,
    ranges, reach, requirements, roots, stations, textures, types, used_phenomena,
};

/// What the check of a file rests on, besides the file.
#[derive(Clone, Copy)]
pub(super) struct Given<'g> {
    /// The node types there are.
    pub library: &'g NodeLibrary,
    /// Where files come from.
    pub files: &'g dyn Files,
    /// The files that were reached, as far as they are phenomena that can be used.
    pub checked: &'g [Option<Rc<Nested>>],
}

/// What a phenomenon says of itself.
struct Header {
    name: String,
    version: i32,
    doc: String,
}

/// Checks a phenomenon, which names other files; the graph has no nested phenomena any more.
pub(super) fn check<'d>(reader: &mut Reader<'d>, given: Given<'d>, named: Named) -> Option<Nested> {
    let root = &reader.document.root;
    if !is_graph(reader, root) || !reader.reads_format(root) {
        return None;
    }
    let object = reader.object(root, keys::PHENOMENON.what, &keys::PHENOMENON.names())?;
    let header = read_header(reader, &object);
    let mut draft = Draft::new(given.library, reader.findings.has_errors());
    let nodes = object.optional("nodes");
    used_phenomena::declare(reader, nodes, &mut draft, named, given.checked);
    interface::read(reader, object.optional("interface"), &mut draft);
    nodes::read(reader, nodes, &mut draft)?;
    roots::read(reader, root, object.optional("roots"), &mut draft);
    let order = cycles::order(reader, &draft);
    let types = types::resolve(&draft, &order);
    let (nodes, roots) = bind_inputs::bind(reader, &draft, &types);
    let requirements = requirements::check(reader, object.optional("requires"), &draft);
    let outside_loops = loops::check(reader, &draft);
    stations::check(reader, &draft);
    reach::check(reader, &draft);
    let ruled_out = check_values(reader, &draft, &nodes, &order);
    textures::check(reader, given.files);
    let parameters = draft.parameters.iter_mut().filter_map(|given| given.parameter.take());
    let parameters = parameters.collect();
    let Header { name, version, doc } = header;
    let library = given.library.clone();
    let graph =
        Graph { library, name, doc, version, requirements, parameters, nodes, roots, ruled_out };
    if draft.phenomena.values().any(Option::is_none) || reader.findings.has_errors() {
        return None;
    }
    let graph = match draft.nested.is_empty() {
        true => graph,
        false => expand::expand(reader, &draft, graph)?,
    };
    let shapes = draft.compounds.drain(..).filter(|(name, _)| !name.contains(['.', '[']));
    Some(Nested::new(graph, outside_loops, shapes.collect()))
}

fn read_header<'d>(reader: &mut Reader<'d>, object: &Object<'d>) -> Header {
    let name = object.optional("phenomenon").and_then(|value| {
        let name = reader.string(value, "the name of the phenomenon")?;
        names::check_name(reader, value, "the name of the phenomenon", name);
        Some(name)
    });
    let version = object
        .optional("version")
        .and_then(|value| reader.integer(value, "`version`", 0..=i32::MAX));
    let doc = object.optional("doc").and_then(|value| reader.string(value, "`doc`"));
    if let Some(value) = object.optional("$schema") {
        reader.string(value, "`$schema`");
    }
    Header {
        name: name.unwrap_or_default().to_owned(),
        version: version.unwrap_or_default(),
        doc: doc.unwrap_or_default().to_owned(),
    }
}

/// Checks what values the nodes come to have; yields the inputs that are never asked for.
fn check_values(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    nodes: &[Node],
    order: &[usize],
) -> Vec<(usize, usize)> {
    let intervals = Intervals::of(draft, nodes, order);
    ranges::check(reader, draft, &intervals);
    hazards::check(reader, draft, &intervals);
    dead_inputs::check(reader, draft, &intervals);
    intervals.ruled_out()
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
