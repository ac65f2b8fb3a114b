//! The check of one phenomenon.

use std::cell::Cell;
use std::collections::HashMap;

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, Value, ValueKind};
use crate::graph::Graph;

use super::draft::{Draft, Suggestions};
use super::intervals::Intervals;
use super::limits::MAX_NODES;
use super::nest::Nest;
use super::nested::Nested;
use super::{
    bind_inputs, cycles, dead_inputs, expand, hazards, interface, keys, light_loops, names, nodes,
    ranges, reach, requirements, roots, stations, textures, types,
};

/// Checks a phenomenon; the graph has no nested phenomena any more.
pub(super) fn check<'d>(reader: &mut Reader<'d>, nest: &mut Nest<'_>) -> Option<Nested> {
    let root = &reader.document.root;
    if !is_graph(reader, root) || !reader.reads_format(root) {
        return None;
    }
    let object = reader.object(root, "a phenomenon", &keys::PHENOMENON)?;
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
