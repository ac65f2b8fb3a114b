//! The phenomena a file or a phenomenon in it names, as types of its nodes.

use std::rc::Rc;

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::{Reader, Value, ValueKind};
use crate::nodes::NodeType;

use super::draft::Draft;
use super::inner::{Found, Inner, inner_of};
use super::limits::MAX_FILE_DEPTH;
use super::literals::beside;
use super::nested::Nested;
use super::reachable::{Named, Target, file_of};

/// What the names may mean.
pub(super) struct Known<'k, 'd> {
    /// The files the document names.
    pub named: &'k mut Named,
    /// The files that were reached, as far as they are phenomena that can be used.
    pub files: &'k [Option<Rc<Nested>>],
    /// What stands in the file.
    pub inner: &'k Inner<'d>,
    /// Position in it of the phenomenon whose nodes these are.
    pub scope: usize,
}

/// Makes node types of the phenomena that `nodes` uses, as far as they are right. What is wrong with a
/// name is told where it stands.
pub(super) fn declare<'d>(
    reader: &mut Reader<'d>,
    nodes: Option<&'d Value>,
    draft: &mut Draft<'d>,
    known: Known<'_, 'd>,
) {
    for member in nodes.map_or(&[][..], Value::members) {
        let Some(value) = member.value.get("type") else { continue };
        if let Some(file) = file_of(value) {
            if draft.phenomena.contains_key(file) {
                continue;
            }
            reader.object(value, "the type of a node", &["file"]);
            let nested = of_file(reader, known.named, known.files, file);
            let path = beside(&reader.document.file.name, file).display().to_string();
            let node_type = nested.and_then(|nested| {
                let definition = nested.definition(path);
                add(reader, draft, value, nested, |draft| draft.node_types.add(definition))
            });
            draft.phenomena.insert(file, node_type);
        } else if let Some(name) = inner_of(value) {
            if draft.inner.contains_key(name) {
                continue;
            }
            reader.object(value, "the type of a node", &["phenomenon"]);
            let nested = of_name(reader, &known, value, name);
            let node_type = nested.and_then(|nested| {
                let definition = nested.definition(name.to_owned());
                add(reader, draft, value, nested, |draft| draft.node_types.add_inner(definition))
            });
            draft.inner.insert(name, node_type);
        }
    }
    // Named as if they were of the library: known, so that it can be said what to write.
    for member in nodes.map_or(&[][..], Value::members) {
        if let Some(ValueKind::String(name)) = member.value.get("type").map(|value| &value.kind)
            && draft.node_types.library.find(name).is_none()
            && known.inner.find(known.scope, name).is_some()
        {
            draft.inner.entry(name).or_insert(None);
        }
    }
}

/// The phenomenon in a file.
fn of_file(
    reader: &mut Reader<'_>,
    named: &mut Named,
    files: &[Option<Rc<Nested>>],
    file: &str,
) -> Option<Rc<Nested>> {
    match named.get_mut(file)? {
        Target::Reached(at) => files.get(*at).cloned().flatten(),
        // Told where the file is named first.
        Target::Refused(finding) => {
            finding.take().into_iter().for_each(|finding| reader.findings.push(finding));
            None
        }
    }
}

/// The phenomenon of that name in the same file.
fn of_name(
    reader: &mut Reader<'_>,
    known: &Known<'_, '_>,
    value: &Value,
    name: &str,
) -> Option<Rc<Nested>> {
    match known.inner.find(known.scope, name) {
        Some(Found::Nested(nested)) => Some(nested),
        Some(Found::Broken) => None,
        None => {
            let advice = known.inner.advice(reader, known.scope, name);
            let place = reader.document.place(value.get("phenomenon").unwrap_or(value));
            let message = format!("no phenomenon `{}` stands in this file", shortened(name));
            reader.findings.push(Finding::misspelt(
                Code::UNKNOWN_PHENOMENON,
                place,
                message,
                advice,
            ));
            None
        }
    }
}

/// Makes a node type of a phenomenon, unless too many are within one another then.
fn add<'d>(
    reader: &mut Reader<'_>,
    draft: &mut Draft<'d>,
    value: &Value,
    nested: Rc<Nested>,
    node_type: impl FnOnce(&mut Draft<'d>) -> NodeType,
) -> Option<NodeType> {
    if nested.depth >= MAX_FILE_DEPTH {
        let message = format!("more than {MAX_FILE_DEPTH} phenomena are nested within one another");
        let help = "use the inner phenomena side by side, not within one another";
        reader.report(Code::RECURSION, value, message, help);
        return None;
    }
    draft.depth = draft.depth.max(nested.depth + 1);
    let node_type = node_type(draft);
    draft.nested.insert(node_type, nested);
    Some(node_type)
}
