//! Where the characters of a string stand in its file.

use super::Span;

/// For each byte of a string, escapes resolved, the byte of the file it was written at.
#[derive(Clone, Debug)]
pub(crate) struct Offsets {
    at: Vec<usize>,
}

impl Offsets {
    /// Those of the string of JSON that stands in `text` from `start` on, at its quote, to `end`, past the closing one.
    pub fn of(text: &str, start: usize, end: usize) -> Self {
        let (from, to) = (start + 1, end.saturating_sub(1));
        let raw = text.get(from..to).unwrap_or("");
        let mut at = Vec::with_capacity(raw.len() + 1);
        let mut rest = raw;
        while let Some(c) = rest.chars().next() {
            let here = to - rest.len();
            let (length, bytes) = written(rest, c);
            at.resize(at.len() + bytes, here);
            rest = &rest[length..];
        }
        at.push(to);
        Self { at }
    }

    /// The bytes of the file of a piece of the string; what is empty, or past it, is its last character.
    pub fn place(&self, span: &Span) -> (usize, usize) {
        let last = self.at.len() - 1;
        let (start, end) = (self.at[span.start.min(last)], self.at[span.end.min(last)]);
        (start, end.max(start))
    }
}

/// How long a character is in the file, and how many bytes it is. `rest` begins with it.
fn written(rest: &str, c: char) -> (usize, usize) {
    if c != '\\' {
        return (c.len_utf8(), c.len_utf8());
    }
    if rest.as_bytes().get(1) != Some(&b'u') {
        return (2.min(rest.len()), 1);
    }
    let unit = |at: usize| rest.get(at..at + 4).and_then(|hex| u16::from_str_radix(hex, 16).ok());
    match unit(2) {
        Some(0xd800..=0xdbff) => (12.min(rest.len()), 4),
        Some(unit) => {
            (6, char::from_u32(u32::from(unit)).map_or('\u{fffd}'.len_utf8(), char::len_utf8))
        }
        None => (rest.len(), 1),
    }
}
