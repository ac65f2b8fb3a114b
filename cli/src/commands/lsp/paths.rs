//! Files that may be named where the cursor stands.

use std::path::Path;

use lsp_types::{CompletionItem, CompletionItemKind, CompletionTextEdit, TextEdit};

use phenomenon_compiler::check::keys::sections;
use phenomenon_compiler::document::{GRAPH_FILES, Kind};
use phenomenon_runtime::scene_file::SCENE;

use super::file::OpenFile;

/// Most files of a folder that are offered.
const MOST: usize = 1000;

/// The endings of files that a key names; none for keys that name no file. What the tables of keys say of it; besides,
/// a schema may be a file.
pub fn endings(key: &str) -> Option<&'static [&'static str]> {
    if key == "$schema" {
        return Some(GRAPH_FILES);
    }
    let all = SCENE.all().into_iter().chain(sections());
    let mut keys = all.filter_map(|section| section.key(key));
    keys.find_map(|key| match key.kind {
        Kind::File(endings) => Some(endings),
        _ => None,
    })
}

/// Files with these endings, and folders, in the folder that is written so far; `at` is where the cursor stands in the
/// file, behind what is `written`.
pub fn complete(
    file: &OpenFile,
    at: usize,
    written: &str,
    endings: &[&str],
) -> Vec<CompletionItem> {
    let (folder, begun) = match written.rfind('/') {
        Some(slash) => written.split_at(slash + 1),
        None => ("", written),
    };
    let Ok(entries) = file.folder().join(folder).read_dir() else { return Vec::new() };
    let range = file.range_of(&(at.saturating_sub(begun.len())..at));
    let mut items = Vec::new();
    for entry in entries.flatten().take(MOST) {
        // A name that is no Unicode cannot be written in JSON.
        let Ok(mut name) = entry.file_name().into_string() else { continue };
        let is_folder = entry.path().is_dir();
        let suits = Path::new(&name).extension().and_then(|ending| ending.to_str());
        let suits = suits.is_some_and(|of| endings.iter().any(|it| of.eq_ignore_ascii_case(it)));
        if name.starts_with('.') || !is_folder && !suits {
            continue;
        }
        let kind = match is_folder {
            true => CompletionItemKind::FOLDER,
            false => CompletionItemKind::FILE,
        };
        if is_folder {
            name.push('/');
        }
        let edit = TextEdit { range, new_text: escaped(&name) };
        items.push(CompletionItem {
            label: name,
            kind: Some(kind),
            text_edit: Some(CompletionTextEdit::Edit(edit)),
            ..CompletionItem::default()
        });
    }
    items.sort_by(|a, b| a.label.cmp(&b.label));
    items
}

/// A name as it stands within a string.
fn escaped(name: &str) -> String {
    let quoted = super::offers::quoted(name);
    quoted[1..quoted.len() - 1].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_say_which_keys_name_files() {
        for (key, ending) in [
            ("file", "json"),
            ("mesh", "obj"),
            ("second_uv", "obj"),
            ("texture", "png"),
            ("image", "exr"),
            ("$schema", "json"),
        ] {
            assert!(endings(key).is_some_and(|of| of.contains(&ending)), "{key}");
        }
        for other in ["doc", "type", "node", "phenomenon", ""] {
            assert!(endings(other).is_none(), "{other}");
        }
    }
}
