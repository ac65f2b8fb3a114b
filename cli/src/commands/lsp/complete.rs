//! What can be written where the cursor stands.

use phenomenon_compiler::check::keys;
use phenomenon_compiler::document::Member;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::{Key, Kind};
use serde_json::{Value, json};

use super::cursor::Cursor;
use super::file::OpenFile;
use super::open_files::OpenFiles;
use super::parts::{Part, members, of_phenomenon, parts_of, text};
use super::scene_keys::{self, Spot};
use crate::ours::Ours;

/// Kinds of completions, as the protocol numbers them.
const FIELD: u8 = 5;
const VARIABLE: u8 = 6;
const CLASS: u8 = 7;
const PROPERTY: u8 = 10;

/// Completions at a byte of the file.
pub fn complete(
    file: &OpenFile,
    at: usize,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Vec<Value> {
    let Some(ours) = file.ours else { return Vec::new() };
    let cursor = Cursor::after(&file.text()[..at]);
    let path: Vec<&str> = cursor.path.iter().map(String::as_str).collect();
    let item = |label: &str, kind: u8, detail: &str, doc: &str| {
        // Within a string its quotes are there; outside they are put in.
        let text = if cursor.written.is_some() { label.to_owned() } else { format!("{label:?}") };
        json!({ "label": label, "kind": kind, "detail": detail, "documentation": doc, "insertText": text })
    };
    let words = |words: &[&str]| -> Vec<Value> {
        words.iter().map(|word| item(word, PROPERTY, "", "")).collect()
    };
    let fields = |parts: Option<Vec<Part>>| -> Vec<Value> {
        let parts = parts.unwrap_or_default();
        parts.iter().map(|part| item(&part.name, FIELD, &part.of, &part.doc)).collect()
    };
    if ours == Ours::Scene {
        return in_scene(file, &cursor, &path, files, &item);
    }
    match (path.as_slice(), cursor.at_key) {
        ([], true) => words(&keys::PHENOMENON),
        (["requires"], true) => words(&keys::REQUIRES),
        (["nodes", _], true) => words(&keys::NODE),
        (["interface", place @ ..], true) if is_declaration(place) => {
            let of = cursor.siblings.get("type").map(String::as_str);
            words(keys::of_declaration(of, cursor.siblings.contains_key("values")))
        }
        (["interface", place @ .., "type"], false) if is_declaration(place) => {
            words(&keys::declared_types())
        }
        (["roots"], true) => words(&RootKind::ALL.map(RootKind::name)),
        (["nodes", _, "type"], false) => {
            let signatures = library.iter().map(|(_, definition)| &definition.signature);
            signatures.map(|it| item(&it.name, CLASS, it.group, &it.doc)).collect()
        }
        (["nodes", name, "inputs"], true) => {
            let written = cursor.around.get(2).and_then(|node| node.get("type"));
            let parts = parts_of(file, name, written.map(String::as_str), library, files);
            fields(parts.map(|parts| parts.inputs))
        }
        (["nodes", name, "inputs", input], false) => {
            let written = cursor.around.get(2).and_then(|node| node.get("type"));
            let parts = parts_of(file, name, written.map(String::as_str), library, files);
            let inputs = parts.map(|parts| parts.inputs).unwrap_or_default();
            let choices = inputs.iter().find(|part| part.name == *input).map(|part| &part.choices);
            choices.into_iter().flatten().map(|choice| item(choice, VARIABLE, "", "")).collect()
        }
        (["nodes" | "roots", .., "node"], false) => {
            let of = |member: &Member| text(&member.value, "type").unwrap_or_default().to_owned();
            let nodes = members(file, "nodes").iter();
            nodes.map(|it| item(&it.key, VARIABLE, &of(it), "")).collect()
        }
        (["nodes" | "roots", .., "output"], false) => {
            let node = cursor.siblings.get("node").map(String::as_str).unwrap_or_default();
            fields(parts_of(file, node, None, library, files).map(|parts| parts.outputs))
        }
        (["nodes" | "roots", .., "interface"], false) => {
            let doc = |member: &Member| text(&member.value, "doc").unwrap_or_default().to_owned();
            let of = |member: &Member| text(&member.value, "type").unwrap_or_default().to_owned();
            let parameters = members(file, "interface").iter();
            parameters.map(|it| item(&it.key, VARIABLE, &of(it), &doc(it))).collect()
        }
        (["nodes", _, "inputs", _] | ["roots", _], true) => words(&keys::CONNECTION),
        _ => Vec::new(),
    }
}

/// Whether a place below `interface` is that of a declaration: of a parameter, of an element, or of a member.
fn is_declaration(place: &[&str]) -> bool {
    match place {
        [_] => true,
        [inner @ .., "of"] | [inner @ .., "members", _] => is_declaration(inner),
        _ => false,
    }
}

/// Completions in a scene: its keys, the words they take, and the parameters of the graphs it uses.
fn in_scene(
    file: &OpenFile,
    cursor: &Cursor,
    path: &[&str],
    files: &OpenFiles,
    item: &dyn Fn(&str, u8, &str, &str) -> Value,
) -> Vec<Value> {
    match (scene_keys::spot(path), cursor.at_key) {
        (Some(Spot::Section(section)), true) => {
            let of = |key: &Key| {
                item(key.name, PROPERTY, &scene_keys::detail(key), &scene_keys::doc(key))
            };
            section.keys.iter().map(of).collect()
        }
        (Some(Spot::Value(key)), false) => match key.kind {
            Kind::Word(words) => words.iter().map(|word| item(word, VARIABLE, "", "")).collect(),
            _ => Vec::new(),
        },
        (Some(Spot::Settings), true) => {
            let graph = cursor.around.last().and_then(|material| material.get("file"));
            let parts = graph.and_then(|graph| of_phenomenon(file, graph, files));
            let inputs = parts.map(|parts| parts.inputs).unwrap_or_default();
            inputs.iter().map(|it| item(&it.name, FIELD, &it.of, &it.doc)).collect()
        }
        _ => Vec::new(),
    }
}
