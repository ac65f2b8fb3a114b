//! What can be written where the cursor stands.

use phenomenon_compiler::document::{Member, Value as Node, ValueKind};
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::nodes::{NodeLibrary, Signature};
use serde_json::{Value, json};

use super::cursor::Cursor;
use super::file::OpenFile;

/// Kinds of completions, as the protocol numbers them.
const FIELD: u8 = 5;
const VARIABLE: u8 = 6;
const CLASS: u8 = 7;
const PROPERTY: u8 = 10;

/// Completions at a byte of the file.
pub fn complete(file: &OpenFile, at: usize, library: &NodeLibrary) -> Vec<Value> {
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
    match (path.as_slice(), cursor.at_key) {
        ([], true) => {
            words(&["phenomenon", "version", "doc", "requires", "interface", "nodes", "roots"])
        }
        (["nodes", _], true) => words(&["type", "inputs", "doc", "version"]),
        (["interface", _], true) => words(&[
            "type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "values",
        ]),
        (["interface", _, "type"], false) => {
            words(&["scalar", "integer", "boolean", "color", "vector", "lights"])
        }
        (["roots"], true) => words(&RootKind::ALL.map(RootKind::name)),
        (["nodes", _, "type"], false) => {
            let signatures = library.iter().map(|(_, definition)| &definition.signature);
            signatures.map(|it| item(it.name, CLASS, it.group, &it.doc)).collect()
        }
        (["nodes", name, "inputs"], true) => {
            let written = cursor.around.get(2).and_then(|node| node.get("type"));
            let of = signature(file, library, name, written.map(String::as_str));
            let inputs = of.map(|signature| signature.inputs.as_slice()).unwrap_or_default();
            inputs.iter().map(|it| item(it.name, FIELD, it.value_type.name(), &it.doc)).collect()
        }
        (["nodes" | "roots", .., "node"], false) => {
            let of = |member: &Member| type_name(&member.value).unwrap_or_default().to_owned();
            let nodes = members(file, "nodes").iter();
            nodes.map(|it| item(&it.key, VARIABLE, &of(it), "")).collect()
        }
        (["nodes" | "roots", .., "output"], false) => {
            let node = cursor.siblings.get("node").map(String::as_str).unwrap_or_default();
            let of = signature(file, library, node, None);
            let outputs = of.map(|signature| signature.outputs.as_slice()).unwrap_or_default();
            outputs.iter().map(|it| item(it.name, FIELD, it.value_type.name(), &it.doc)).collect()
        }
        (["nodes" | "roots", .., "interface"], false) => {
            let doc = |member: &Member| text(&member.value, "doc").unwrap_or_default().to_owned();
            let of = |member: &Member| text(&member.value, "type").unwrap_or_default().to_owned();
            let parameters = members(file, "interface").iter();
            parameters.map(|it| item(&it.key, VARIABLE, &of(it), &doc(it))).collect()
        }
        (["nodes", _, "inputs", _] | ["roots", _], true) => words(&["node", "output", "interface"]),
        _ => Vec::new(),
    }
}

/// The members of a part of the file, as it was JSON last.
pub fn members<'f>(file: &'f OpenFile, part: &str) -> &'f [Member] {
    let part = file.document.as_ref().and_then(|document| document.root.get(part));
    part.map_or(&[], Node::members)
}

/// The string under a key.
pub fn text<'f>(value: &'f Node, key: &str) -> Option<&'f str> {
    match &value.get(key)?.kind {
        ValueKind::String(text) => Some(text),
        _ => None,
    }
}

fn type_name(node: &Node) -> Option<&str> {
    text(node, "type")
}

/// The signature of a node's type: the one written before the cursor, or else that of the file.
pub fn signature<'l>(
    file: &OpenFile,
    library: &'l NodeLibrary,
    node: &str,
    written: Option<&str>,
) -> Option<&'l Signature> {
    let known = members(file, "nodes").iter().find(|member| member.key == node);
    let name = written.or(known.and_then(|member| type_name(&member.value)))?;
    library.find(name).map(|node_type| library.signature(node_type))
}
