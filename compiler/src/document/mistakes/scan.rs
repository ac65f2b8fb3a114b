//! The passes over a file that is no JSON, and their mistakes as findings.

use std::sync::Arc;

use crate::diagnostics::{Code, Finding, Place, SourceFile};

use super::mistake::{MAX_MISTAKES, Mistake};
use super::{brackets, grammar};

/// What is wrong in a text that is no JSON, in file order; none where nothing was recognised.
pub(in crate::document) fn all(file: &Arc<SourceFile>) -> Vec<Finding> {
    let text = file.text.as_str();
    let corrections = brackets::corrections(text);
    let mut mistakes = grammar::mistakes(text, &corrections);
    mistakes.extend(corrections.mistakes);
    mistakes.sort_by_key(|mistake| mistake.start);
    mistakes.truncate(MAX_MISTAKES);
    mistakes.into_iter().map(|mistake| finding(file, mistake)).collect()
}

fn finding(file: &Arc<SourceFile>, mistake: Mistake) -> Finding {
    let text = &file.text;
    let place = |start: usize, end: usize| {
        let start = text.floor_char_boundary(start.min(text.len()));
        let end = text.ceil_char_boundary(end.min(text.len())).max(start);
        Place { file: file.clone(), start, end, path: String::new() }
    };
    let at = place(mistake.start, mistake.end);
    let mut finding = Finding::new(Code::SYNTAX, at, mistake.message, mistake.help);
    finding.fix = mistake.fix;
    for (start, end, message) in mistake.related {
        finding = finding.with_related(place(start, end), message);
    }
    finding
}
