//! The docs of what is under the pointer.

use phenomenon_compiler::nodes::{FINITE, Input, NodeLibrary, Signature};
use serde_json::{Value, json};

use super::complete::{members, signature, text};
use super::file::OpenFile;

/// What there is to say about a byte of the file; null for nothing.
pub fn hover(file: &OpenFile, at: usize, library: &NodeLibrary) -> Value {
    // Places are those of the text that was JSON last; while it is not, they may be off.
    let Some(document) = file.document.as_ref().filter(|it| it.file.text == file.text()) else {
        return Value::Null;
    };
    let place = document.place_of_bytes(at, at);
    let path: Vec<&str> = place.path.split('.').collect();
    let told = match path.as_slice() {
        ["nodes", .., "node" | "output"] | ["roots", .., "node" | "output"] => {
            let connection = innermost(&document.root, at);
            let node = connection.and_then(|connection| text(connection, "node"));
            node.and_then(|node| signature(file, library, node, None)).map(of_node)
        }
        ["nodes" | "roots", .., "interface"] => {
            let connection = innermost(&document.root, at);
            connection.and_then(|it| text(it, "interface")).and_then(|name| parameter(file, name))
        }
        ["nodes", name] | ["nodes", name, "type"] => {
            signature(file, library, name, None).map(of_node)
        }
        ["nodes", name, "inputs", input, ..] => {
            let inputs = signature(file, library, name, None).map(|it| it.inputs.as_slice());
            inputs.unwrap_or_default().iter().find(|it| it.name == *input).map(of_input)
        }
        ["interface", name, ..] => parameter(file, name),
        _ => None,
    };
    match told {
        Some(told) => json!({ "contents": { "kind": "markdown", "value": told } }),
        None => Value::Null,
    }
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

fn of_node(signature: &Signature) -> String {
    let names = |names: Vec<String>| names.join(", ");
    let inputs =
        signature.inputs.iter().map(|it| format!("`{}` {}", it.name, it.value_type.name()));
    let outputs =
        signature.outputs.iter().map(|it| format!("`{}` {}", it.name, it.value_type.name()));
    let mut told = format!(
        "**{}** ({})\n\n{}\n\nInputs: {}\n\nOutputs: {}",
        signature.name,
        signature.group,
        signature.doc,
        names(inputs.collect()),
        names(outputs.collect()),
    );
    if !signature.source.is_empty() {
        told.push_str(&format!("\n\nSource: {}", signature.source));
    }
    told
}

fn of_input(input: &Input) -> String {
    let mut told = format!("`{}` {}\n\n{}", input.name, input.value_type.name(), input.doc);
    if input.range != FINITE {
        told.push_str(&format!("\n\nRange: {} to {}", input.range.start(), input.range.end()));
    }
    told
}

fn parameter(file: &OpenFile, name: &str) -> Option<String> {
    let member = members(file, "interface").iter().find(|member| member.key == name)?;
    let of = text(&member.value, "type").unwrap_or_default();
    let doc = text(&member.value, "doc").unwrap_or_default();
    Some(format!("parameter `{name}` {of}\n\n{doc}"))
}
