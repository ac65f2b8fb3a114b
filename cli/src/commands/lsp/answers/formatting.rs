//! The canonical form of a file.

use lsp_types::TextEdit;
use phenomenon_compiler::document::canonical;

use crate::commands::lsp::file::OpenFile;

/// What brings the file into its canonical form; none while it is not JSON.
pub fn formatting(file: &OpenFile) -> Option<Vec<TextEdit>> {
    let new_text = canonical(file.current()?);
    if new_text == file.text() {
        return Some(Vec::new());
    }
    Some(vec![TextEdit { range: file.range_of(&(0..file.text().len())), new_text }])
}
