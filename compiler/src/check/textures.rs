//! Pictures a graph names: each must be there.

use crate::diagnostics::{Code, shortened};
use crate::document::{Reader, ValueKind};

use super::files::Files;
use super::literals::beside;

/// Reports every picture that was named so far and cannot be opened.
pub(super) fn check(reader: &mut Reader<'_>, files: &dyn Files) {
    for value in std::mem::take(&mut reader.files) {
        let ValueKind::String(file) = &value.kind else { continue };
        let path = beside(&reader.document.file.name, file);
        if let Some((code, why)) = files.unusable_picture(&path) {
            let message = format!("the texture `{}` cannot be used: {why}", shortened(file));
            let help = match code {
                Code::UNREADABLE_FILE => "paths are relative to the folder of this file",
                _ => "write the picture again, smaller if need be, or name another",
            };
            reader.report(code, value, message, help);
        }
    }
}
