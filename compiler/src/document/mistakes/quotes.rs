//! Strings in quotes that JSON does not have.

use super::characters::{ends_a_value, is_typographic, line_end};
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;

/// How far the closing quote is looked for.
const REACH: usize = 4096;

/// Text between quotes as it stands between double quotes.
pub(super) fn json(inner: &str) -> String {
    let mut text = String::with_capacity(inner.len());
    let mut characters = inner.chars();
    while let Some(c) = characters.next() {
        match c {
            '"' => text.push_str("\\\""),
            '\\' => match characters.next() {
                // No escape of JSON, and none is needed.
                Some('\'') => text.push('\''),
                Some(next) => text.extend(['\\', next]),
                None => text.push_str("\\\\"),
            },
            c => text.push(c),
        }
    }
    text
}

impl Lexer<'_> {
    /// A string that starts with a quote which JSON does not have; it is read.
    pub fn quoted(&mut self, start: usize, open: char) -> Token {
        let from = self.at;
        let line = &self.text[from..line_end(self.text, from)];
        let line = &line[..line.floor_char_boundary(REACH)];
        let closes = |c: char| match open {
            '\'' | '`' | '´' => c == open || (open == '`' && c == '\'') || c == '´',
            '‘' | '’' | '‚' | '‛' | '′' => matches!(c, '‘' | '’' | '‛' | '′' | '\''),
            _ => c == '"' || is_typographic(c) && !matches!(c, '‘' | '’' | '‚' | '‛' | '′'),
        };
        let is_free = |at: usize| !line[..at].ends_with('\\');
        let mut candidates = line.char_indices().filter(|(at, c)| closes(*c) && is_free(*at));
        // Within the text there may be an apostrophe, or a word in quotes.
        let close = candidates
            .clone()
            .find(|(at, c)| ends_a_value(&line[at + c.len_utf8()..]))
            .or_else(|| candidates.next());
        let (message, help) = match open {
            '\'' | '`' | '´' => (
                "a string must stand in double quotes".to_owned(),
                format!("write `\"` instead of `{open}`"),
            ),
            _ => (
                format!("typographic quotes such as `{open}` are no quotes of JSON"),
                "write `\"`".to_owned(),
            ),
        };
        match close {
            Some((at, c)) => {
                self.at = from + at + c.len_utf8();
                let fixed = format!("\"{}\"", json(&line[..at]));
                let mistake = Mistake::new((start, self.at), message, help);
                self.tell(mistake.fixed_by(fixed));
            }
            None => {
                let length = line.find([',', ':', '}', ']']).unwrap_or(line.trim_end().len());
                self.at = from + length;
                self.tell(Mistake::new((start, from), message, help));
            }
        }
        self.token(Kind::String, start)
    }
}
