//! Files and places in them.

use std::sync::{Arc, OnceLock};

/// A text file that findings point into.
#[derive(Debug, Default)]
pub struct SourceFile {
    /// As the user named it.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Byte at which each line starts, found when first asked for: a file may have a million
    /// findings, and each must not count lines anew.
    line_starts: OnceLock<Vec<usize>>,
}

impl PartialEq for SourceFile {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.text == other.text
    }
}

impl Eq for SourceFile {}

impl SourceFile {
    /// A file of that name and text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into(), line_starts: OnceLock::new() }
    }

    /// Line and column of a byte, from 1; columns count characters.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let byte = self.text.floor_char_boundary(byte);
        let starts = self.line_starts.get_or_init(|| {
            let breaks = self.text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
            std::iter::once(0).chain(breaks.map(|(at, _)| at + 1)).collect()
        });
        let line = starts.partition_point(|&start| start <= byte);
        let start = starts[line - 1];
        (line, self.text[start..byte].chars().count() + 1)
    }
}

/// A range of bytes of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: Arc<SourceFile>,
    /// First byte.
    pub start: usize,
    /// Past the last byte.
    pub end: usize,
    /// JSON path, such as `nodes.shade.inputs.weight`.
    pub path: String,
}

impl Place {
    /// Line and column of the start, from 1; columns count characters.
    pub fn line_column(&self) -> (usize, usize) {
        self.file.line_column(self.start)
    }

    /// Line and column past the end, from 1; columns count characters.
    pub fn end_line_column(&self) -> (usize, usize) {
        self.file.line_column(self.end)
    }

    /// The text of the range.
    pub fn text(&self) -> &str {
        let text = &self.file.text;
        &text[text.floor_char_boundary(self.start)..text.floor_char_boundary(self.end)]
    }

    /// Number of characters in the range.
    pub fn length(&self) -> usize {
        self.text().chars().count()
    }
}
