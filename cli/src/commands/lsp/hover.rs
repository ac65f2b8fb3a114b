//! The docs of what is under the pointer.

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::schema::Key;
use serde_json::{Value, json};

use super::file::OpenFile;
use super::open_files::OpenFiles;
use super::parts::{Part, Parts, members, parts_of, text};
use super::scene_keys;
use crate::ours::Ours;

/// What there is to say about a byte of the file; null for nothing.
pub fn hover(file: &OpenFile, at: usize, library: &NodeLibrary, files: &OpenFiles) -> Value {
    // Places are those of the text that was JSON last; while it is not, they may be off.
    let Some(document) = file.document.as_ref().filter(|it| it.file.text == file.text()) else {
        return Value::Null;
    };
    let place = document.place_of_bytes(at, at);
    let path: Vec<&str> = place.path.split('.').collect();
    if file.ours == Some(Ours::Scene) {
        // Where something stands in a list says nothing of its key.
        let keys: Vec<&str> =
            path.iter().map(|key| key.split('[').next().unwrap_or_default()).collect();
        return told(scene_keys::key(&keys).map(of_key));
    }
    let parts = |node: &str| parts_of(file, node, None, library, files);
    told(match path.as_slice() {
        ["nodes", .., "node" | "output"] | ["roots", .., "node" | "output"] => {
            let connection = innermost(&document.root, at);
            let node = connection.and_then(|connection| text(connection, "node"));
            node.and_then(parts).as_ref().map(of_node)
        }
        ["nodes" | "roots", .., "interface"] => {
            let connection = innermost(&document.root, at);
            connection.and_then(|it| text(it, "interface")).and_then(|name| parameter(file, name))
        }
        ["nodes", name] | ["nodes", name, "type"] | ["nodes", name, "type", "file"] => {
            parts(name).as_ref().map(of_node)
        }
        ["nodes", name, "inputs", input, ..] => {
            let inputs = parts(name).map(|parts| parts.inputs).unwrap_or_default();
            inputs.iter().find(|it| it.name == *input).map(of_input)
        }
        ["interface", name, ..] => parameter(file, name),
        _ => None,
    })
}

fn told(told: Option<String>) -> Value {
    match told {
        Some(told) => json!({ "contents": { "kind": "markdown", "value": told } }),
        None => Value::Null,
    }
}

fn of_key(key: &Key) -> String {
    format!("`{}` {}\n\n{}", key.name, scene_keys::detail(key), scene_keys::doc(key))
}

/// The innermost object round a byte.
fn innermost(
    value: &phenomenon_compiler::document::Value,
    at: usize,
) -> Option<&phenomenon_compiler::document::Value> {
    let mut value = value;
    let mut found = None;
    while !value.members().is_empty() {
        found = Some(value);
        let inside =
            |value: &phenomenon_compiler::document::Value| value.start <= at && at < value.end;
        match value.members().iter().find(|member| inside(&member.value)) {
            Some(member) => value = &member.value,
            None => break,
        }
    }
    found
}

fn of_node(parts: &Parts) -> String {
    let listed = |parts: &[Part]| {
        let names: Vec<String> =
            parts.iter().map(|part| format!("`{}` {}", part.name, part.of)).collect();
        names.join(", ")
    };
    let Parts { title, doc, source, inputs, outputs } = parts;
    let (inputs, outputs) = (listed(inputs), listed(outputs));
    let mut told = format!("{title}\n\n{doc}\n\nInputs: {inputs}\n\nOutputs: {outputs}");
    if !source.is_empty() {
        told.push_str(&format!("\n\nSource: {source}"));
    }
    told
}

fn of_input(input: &Part) -> String {
    format!("`{}` {}\n\n{}", input.name, input.of, input.doc)
}

fn parameter(file: &OpenFile, name: &str) -> Option<String> {
    let member = members(file, "interface").iter().find(|member| member.key == name)?;
    let of = text(&member.value, "type").unwrap_or_default();
    let doc = text(&member.value, "doc").unwrap_or_default();
    Some(format!("parameter `{name}` {of}\n\n{doc}"))
}
