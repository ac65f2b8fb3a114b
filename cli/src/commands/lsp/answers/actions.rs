//! The fixes of findings, for the editor to put in.

use lsp_types::{CodeAction, CodeActionKind, CodeActionOrCommand, Range, TextEdit};

use super::rename::edit_of;
use crate::commands::lsp::file::OpenFile;

/// What mends the findings within a range.
pub fn actions(file: &OpenFile, within: Range) -> Vec<CodeActionOrCommand> {
    let mends = file.fixes().filter(|(diagnostic, _)| {
        let range = diagnostic.range;
        range.start <= within.end && within.start <= range.end
    });
    let action = |(diagnostic, fix): (lsp_types::Diagnostic, &str)| {
        let edit = TextEdit { range: diagnostic.range, new_text: fix.into() };
        CodeActionOrCommand::CodeAction(CodeAction {
            title: format!("Write {fix}"),
            kind: Some(CodeActionKind::QUICKFIX),
            edit: Some(edit_of([(file.uri().to_owned(), vec![edit])])),
            is_preferred: Some(true),
            diagnostics: Some(vec![diagnostic]),
            ..CodeAction::default()
        })
    };
    mends.map(action).collect()
}
