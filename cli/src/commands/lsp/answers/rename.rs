//! Another name for what has one.

use std::collections::HashMap;

use lsp_types::{DocumentChanges, OneOf, PrepareRenameResponse, TextDocumentEdit, TextEdit};
use lsp_types::{OptionalVersionedTextDocumentIdentifier, Uri, WorkspaceEdit};
use phenomenon_compiler::check::name_mistake;
use phenomenon_compiler::document::{Member, Role, Value, ValueKind, words};

use crate::commands::lsp::address::names_of;
use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::names::{self, Name, NameKind};
use crate::commands::lsp::open_files::OpenFiles;
use crate::commands::lsp::part::text;

/// What would be renamed at a byte.
pub fn prepare(file: &OpenFile, at: usize) -> Option<PrepareRenameResponse> {
    let index = names::index(file.current()?);
    let name = index.name_at(at)?;
    let place = index.place_at(at)?;
    Some(PrepareRenameResponse::RangeWithPlaceholder {
        range: file.range_of(&place),
        placeholder: name.name.clone(),
    })
}

/// Gives another name to what has one under a byte, here and, of a parameter, in the open files that set it.
///
/// # Errors
/// There is no name there, or the new one cannot be had; in words.
pub fn rename(
    file: &OpenFile,
    at: usize,
    new: &str,
    files: &OpenFiles,
) -> Result<WorkspaceEdit, String> {
    let document = file.current().ok_or("the file is not JSON now: mend that first")?;
    let index = names::index(document);
    let name = index.name_at(at).ok_or("nothing that has a name stands there")?;
    if let Some(mistake) = name_mistake("the name", new) {
        return Err(format!("{mistake}: use letters, digits, `_` and `-`, at most 256 of them"));
    }
    let in_expressions =
        name.kind == NameKind::Bound || index.uses_of(name).any(|used| used.in_expression);
    if in_expressions && !is_word(new) {
        return Err(
            "expressions name it, so the new name is a letter or `_`, then letters, digits and `_`"
                .into(),
        );
    }
    // What an expression names by one name must not be two things, nor be hidden.
    let in_reach = |other: &Name| match other.kind {
        NameKind::Node | NameKind::Parameter => {
            other.scope == name.scope || name.kind == NameKind::Bound
        }
        NameKind::Bound => true,
        _ => false,
    };
    let is_taken = |other: &Name| {
        let same = other.kind == name.kind && other.scope == name.scope;
        other.name == new && (same || in_expressions && in_reach(other))
    };
    if new != name.name && index.names.iter().any(is_taken) {
        return Err(format!("`{new}` is there already: choose another name"));
    }
    let edit = |range| TextEdit { range, new_text: new.to_owned() };
    let places = std::iter::once(&name.place).chain(index.uses_of(name).map(|used| &used.place));
    let here = places.map(|place| edit(file.range_of(place))).collect();
    let mut edits = vec![(file.uri().to_owned(), here)];
    if name.kind == NameKind::Parameter && name.scope == 0 {
        for user in files.iter().filter(|user| user.uri() != file.uri() && user.uses(&file.names)) {
            let places = settings(user, file, &name.name);
            if !places.is_empty() {
                let there = places.iter().map(|place| edit(user.range_of(place))).collect();
                edits.push((user.uri().to_owned(), there));
            }
        }
    }
    Ok(edit_of(edits))
}

/// Whether an expression can name something so.
fn is_word(name: &str) -> bool {
    let found = words(name);
    matches!(found.as_slice(), [only] if only.role == Role::Value && only.name == name)
}

/// Edits of files by their addresses, which need not be ones that `lsp_types` reads.
pub fn edit_of(edits: impl IntoIterator<Item = (String, Vec<TextEdit>)>) -> WorkspaceEdit {
    let edit = |(uri, edits): (String, Vec<TextEdit>)| {
        let uri: Uri = uri.parse().ok()?;
        let text_document = OptionalVersionedTextDocumentIdentifier { uri, version: None };
        let edits = edits.into_iter().map(OneOf::Left).collect();
        Some(TextDocumentEdit { text_document, edits })
    };
    let edits = edits.into_iter().filter_map(edit).collect();
    WorkspaceEdit {
        changes: None::<HashMap<Uri, Vec<TextEdit>>>,
        document_changes: Some(DocumentChanges::Edits(edits)),
        change_annotations: None,
    }
}

/// Where a file that uses `of` gives a value to its parameter: as an input of a node, or in a `set`.
fn settings(user: &OpenFile, of: &OpenFile, parameter: &str) -> Vec<std::ops::Range<usize>> {
    let Some(document) = user.current() else { return Vec::new() };
    let names_it = |value: &Value| {
        let named = text(value, "file")?;
        let names = names_of(&user.folder().join(named));
        of.names.iter().any(|name| names.contains(name)).then_some(())
    };
    let mut places = Vec::new();
    let mut pending = vec![&document.root];
    while let Some(value) = pending.pop() {
        let set = match value.get("type") {
            Some(of) if names_it(of).is_some() => value.get("inputs"),
            _ if names_it(value).is_some() => value.get("set"),
            _ => None,
        };
        let keys = set.map_or(&[][..], Value::members).iter();
        places.extend(keys.filter_map(|member| head_of(member, parameter)));
        match &value.kind {
            ValueKind::Array(elements) => pending.extend(elements),
            ValueKind::Object(members) => pending.extend(members.iter().map(|it| &it.value)),
            _ => {}
        }
    }
    places.sort_by_key(|place| place.start);
    places
}

/// The bytes of a parameter's name in a key that sets it or a part of it.
fn head_of(member: &Member, parameter: &str) -> Option<std::ops::Range<usize>> {
    let rest = member.key.strip_prefix(parameter)?;
    let is_it = rest.is_empty() || rest.starts_with(['.', '[']);
    let start = member.key_start + 1;
    is_it.then(|| start..start + parameter.len())
}
