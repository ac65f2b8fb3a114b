//! The files that a file names.

use lsp_types::DocumentLink;
use phenomenon_compiler::document::{Value, ValueKind};
use phenomenon_compiler::values::TilePattern;

use crate::commands::lsp::address::uri_of;
use crate::commands::lsp::file::OpenFile;
use crate::commands::lsp::paths::endings;

/// Links to the files that the file names and that are there.
pub fn links(file: &OpenFile) -> Option<Vec<DocumentLink>> {
    let mut links = Vec::new();
    let mut pending = vec![&file.current()?.root];
    while let Some(value) = pending.pop() {
        match &value.kind {
            ValueKind::Array(elements) => pending.extend(elements),
            ValueKind::Object(members) => {
                for member in members {
                    match member.key.as_str() {
                        "editor" => {}
                        key if endings(key).is_some() => links.extend(link(file, &member.value)),
                        _ => pending.push(&member.value),
                    }
                }
            }
            _ => {}
        }
    }
    links.sort_by_key(|link| (link.range.start.line, link.range.start.character));
    Some(links)
}

fn link(file: &OpenFile, value: &Value) -> Option<DocumentLink> {
    let ValueKind::String(named) = &value.kind else { return None };
    let path = file.folder().join(named);
    // Of tiles, the first.
    let tiles = TilePattern::of(&path).and_then(|pattern| pattern.files().ok());
    let path = tiles.and_then(|tiles| tiles.into_iter().next()).map_or(path, |(_, first)| first);
    // A name without a file is a string like others, or a mistake that is told of elsewhere.
    if named.is_empty() || !path.is_file() {
        return None;
    }
    let target = uri_of(&path.canonicalize().ok()?).parse().ok()?;
    let range = file.range_of(&(value.start + 1..value.end - 1));
    Some(DocumentLink { range, target: Some(target), tooltip: None, data: None })
}
