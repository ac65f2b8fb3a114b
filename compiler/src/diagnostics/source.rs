//! Files and places in them.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// Bytes between two entries of [`Index::characters`].
const BLOCK: usize = 4096;

/// A text file that findings point into.
#[derive(Debug, Default)]
pub struct SourceFile {
    /// As the user named it.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Made when first asked for.
    index: OnceLock<Index>,
}

/// What makes a place quick to find: a file may have thousands of findings, or be one line of many
/// megabytes, and no finding must count all that is before it.
#[derive(Debug)]
struct Index {
    /// Byte at which each line starts.
    line_starts: Vec<usize>,
    /// Characters before each block of bytes.
    characters: Vec<usize>,
}

impl PartialEq for SourceFile {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other) || (self.name == other.name && self.text == other.text)
    }
}

impl Eq for SourceFile {}

impl SourceFile {
    /// A file of that name and text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Self { name: name.into(), text: text.into(), index: OnceLock::new() }
    }

    /// Line and column of a byte, from 1; columns count characters.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let byte = self.text.floor_char_boundary(byte);
        let index = self.index();
        let line = index.line_starts.partition_point(|&start| start <= byte);
        let start = index.line_starts[line - 1];
        (line, self.characters_before(byte) - self.characters_before(start) + 1)
    }

    /// The bytes of a line, from 1, without its line break; empty past the last one.
    pub fn line(&self, number: usize) -> Range<usize> {
        let starts = &self.index().line_starts;
        let end = self.text.len();
        let start = starts.get(number.wrapping_sub(1)).copied().unwrap_or(end);
        // Before the start of the next line stands its line break.
        let end = starts.get(number).map_or(end, |next| next.saturating_sub(1)).max(start);
        start..start + self.text[start..end].trim_end_matches('\r').len()
    }

    fn index(&self) -> &Index {
        self.index.get_or_init(|| {
            let bytes = self.text.as_bytes();
            let breaks = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n');
            let mut characters = vec![0];
            let mut before = 0;
            for block in bytes.chunks(BLOCK) {
                before += count_characters(block);
                characters.push(before);
            }
            Index {
                line_starts: std::iter::once(0).chain(breaks.map(|(at, _)| at + 1)).collect(),
                characters,
            }
        })
    }

    fn characters_before(&self, byte: usize) -> usize {
        let block = byte / BLOCK;
        let rest = &self.text.as_bytes()[block * BLOCK..byte];
        self.index().characters[block] + count_characters(rest)
    }
}

/// Characters that start in a piece of UTF-8.
fn count_characters(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| (**byte & 0xc0) != 0x80).count()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_are_counted_in_characters() {
        let text = format!("é😀\r\n{}x\n", "é".repeat(3 * BLOCK));
        let file = SourceFile::new("a", text.as_str());
        assert_eq!(file.line_column(0), (1, 1));
        assert_eq!(file.line_column(2), (1, 2));
        assert_eq!(file.line_column(4), (1, 2), "within a character");
        assert_eq!(file.line_column(8), (2, 1));
        for (line, line_text) in text.split('\n').enumerate() {
            let start = text.split('\n').take(line).map(|line| line.len() + 1).sum::<usize>();
            for (column, (at, _)) in line_text.char_indices().enumerate().step_by(97) {
                assert_eq!(file.line_column(start + at), (line + 1, column + 1));
            }
        }
        assert_eq!(&text[file.line(1)], "é😀");
        assert_eq!(file.line(2), 8..text.len() - 1);
        assert_eq!(
            [file.line(3), file.line(4), file.line(0)],
            [0, 1, 2].map(|_| text.len()..text.len())
        );
        let end = (3, 1);
        assert_eq!((file.line_column(text.len()), file.line_column(usize::MAX)), (end, end));
        assert_eq!(SourceFile::new("", "").line_column(9), (1, 1));
    }
}
