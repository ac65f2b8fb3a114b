//! Pictures a graph names: each must be there.

use crate::diagnostics::Code;
use crate::document::{Reader, Value, ValueKind, shortened};

use super::literals::beside;
use super::nested::Files;

/// Reports every picture in the interface and the nodes that cannot be opened.
pub(super) fn check(reader: &mut Reader<'_>, files: &dyn Files) {
    let root = &reader.document.root;
    let mut named = Vec::new();
    for key in ["interface", "nodes", "roots"] {
        if let Some(value) = root.get(key) {
            collect(value, &mut named);
        }
    }
    for value in named {
        let ValueKind::String(file) = &value.kind else { continue };
        let path = beside(&reader.document.file.name, file);
        if let Some(why) = files.unusable(&path) {
            let message = format!("the texture `{}` cannot be used: {why}", shortened(file));
            let help = "paths are relative to the folder of this file";
            reader.report(Code::UNREADABLE_FILE, value, message, help);
        }
    }
}

/// The files of all textures below a value; the nesting is bounded, and so is this recursion.
fn collect<'d>(value: &'d Value, named: &mut Vec<&'d Value>) {
    match &value.kind {
        ValueKind::Array(elements) => elements.iter().for_each(|element| collect(element, named)),
        ValueKind::Object(members) => {
            for member in members {
                match (member.key.as_str(), &member.value.kind) {
                    ("texture", ValueKind::String(_)) => named.push(&member.value),
                    ("doc" | "editor", _) => {}
                    _ => collect(&member.value, named),
                }
            }
        }
        _ => {}
    }
}
