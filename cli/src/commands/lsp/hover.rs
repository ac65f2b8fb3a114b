//! The docs of what is under the pointer.

use lsp_types::{Hover, HoverContents, MarkupContent, MarkupKind};
use phenomenon_compiler::document::{Key, Value};
use phenomenon_compiler::nodes::NodeLibrary;

use super::expression::Names;
use super::file::OpenFile;
use super::keys;
use super::open_files::OpenFiles;
use super::part::text;
use super::parts::parts_of;
use super::scope::Scope;
use super::told::{of_input, of_node, parameter};
use crate::ours::Ours;

/// What there is to say about a byte of the file.
pub fn hover(
    file: &OpenFile,
    at: usize,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Hover> {
    // Places are those of the text that was JSON last; while it is not, they may be off.
    let document = file.document.as_ref().filter(|it| it.file.text == file.text())?;
    let place = document.place_of_bytes(at, at);
    let path: Vec<&str> = place.path.split('.').collect();
    if file.ours == Some(Ours::Scene) {
        // Where something stands in a list says nothing of its key.
        let path: Vec<&str> =
            path.iter().map(|key| key.split('[').next().unwrap_or_default()).collect();
        return keys::key(&path).map(of_key).map(told);
    }
    let (scope, path) = Scope::of(file, &path);
    if path.last() == Some(&"expression")
        && let Some(object) = innermost(&document.root, at)
    {
        return Names { scope: &scope, library, files }
            .hover(document, (object, path), at)
            .map(told);
    }
    let parts = |node: &str| parts_of(&scope, node, None, library, files);
    let told_of = match path {
        ["nodes" | "roots" | "outputs", .., "node" | "output"] => {
            let connection = innermost(&document.root, at);
            let node = connection.and_then(|connection| text(connection, "node"));
            node.and_then(parts).as_ref().map(of_node)
        }
        ["nodes" | "roots" | "outputs", .., "interface"] => {
            let connection = innermost(&document.root, at);
            connection.and_then(|it| text(it, "interface")).and_then(|name| parameter(&scope, name))
        }
        ["nodes", name]
        | ["nodes", name, "type"]
        | ["nodes", name, "type", "file" | "phenomenon"] => parts(name).as_ref().map(of_node),
        ["nodes", name, "inputs", input, ..] => {
            let inputs = parts(name).map(|parts| parts.inputs).unwrap_or_default();
            inputs.iter().find(|it| it.name == *input).map(of_input)
        }
        ["interface", name, ..] => parameter(&scope, name),
        _ => None,
    };
    told_of.map(told)
}

fn told(value: String) -> Hover {
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
    Hover { contents, range: None }
}

fn of_key(key: &Key) -> String {
    format!("`{}` {}\n\n{}", key.name, keys::detail(key), keys::doc(key))
}

/// The innermost object round a byte.
fn innermost(value: &Value, at: usize) -> Option<&Value> {
    let mut value = value;
    let mut found = None;
    while !value.members().is_empty() {
        found = Some(value);
        let inside = |value: &Value| value.start <= at && at < value.end;
        match value.members().iter().find(|member| inside(&member.value)) {
            Some(member) => value = &member.value,
            None => break,
        }
    }
    found
}
