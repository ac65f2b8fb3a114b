//! All mistakes of a file that is no JSON. The strict parser judges files and stops at what it meets
//! first; this scan is never asked of a file that is right. It tolerates what it can name, so that one
//! run tells every mistake and nothing that only follows from one.
//!
//! It reads the text three times, each time in one pass and with a bounded stack: to count brackets, to
//! find by indentation which are missing or too many, and to follow the grammar.

mod brackets;
mod grammar;
mod quotes;
mod strings;
mod tokens;
mod words;

use std::sync::Arc;

use crate::diagnostics::{Code, Finding, Place, SourceFile};

/// Most mistakes that are told of one file.
const MOST: usize = 1_000;

/// A mistake by bytes of the text.
#[derive(Clone, Debug)]
struct Mistake {
    start: usize,
    end: usize,
    message: String,
    help: String,
    /// What to put in its place, where nothing else can be meant.
    fix: Option<String>,
    related: Vec<(usize, usize, String)>,
}

impl Mistake {
    fn new(
        (start, end): (usize, usize),
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        let (message, help) = (message.into(), help.into());
        Self { start, end, message, help, fix: None, related: Vec::new() }
    }

    fn fixed_by(mut self, text: impl Into<String>) -> Self {
        self.fix = Some(text.into());
        self
    }

    fn with(mut self, (start, end): (usize, usize), message: impl Into<String>) -> Self {
        self.related.push((start, end, message.into()));
        self
    }
}

/// What is wrong in a text that is no JSON, in file order; none where nothing was recognised.
pub(super) fn all(file: &Arc<SourceFile>) -> Vec<Finding> {
    let text = file.text.as_str();
    let corrections = brackets::corrections(text);
    let mut mistakes = grammar::mistakes(text, &corrections);
    mistakes.extend(corrections.mistakes);
    mistakes.sort_by_key(|mistake| mistake.start);
    mistakes.truncate(MOST);
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
