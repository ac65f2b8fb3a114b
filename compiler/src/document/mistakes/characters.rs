//! Classes of characters, and what may stand behind others.

use crate::diagnostics::escaped;

/// Whether a character is a quote of typography, single or double.
pub(super) fn is_typographic(c: char) -> bool {
    matches!(c, '“' | '”' | '„' | '‟' | '″' | '«' | '»' | '＂' | '‘' | '’' | '‚' | '‛' | '′')
}

/// Whether a character opens what is meant as a string.
pub(super) fn opens(c: char) -> bool {
    is_typographic(c) || matches!(c, '\'' | '`' | '´')
}

/// Whether a character is part of a number or a word.
pub(super) fn is_of_a_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '+' | '-' | '.' | '$' | '@' | '%' | '&' | '\\')
}

/// Where the line that holds a byte ends.
pub(super) fn line_end(text: &str, at: usize) -> usize {
    text[at..].find(['\n', '\r']).map_or(text.len(), |found| at + found)
}

/// Whether a character may stand right behind a string.
pub(super) fn follows(c: Option<char>) -> bool {
    c.is_none_or(|c| c.is_whitespace() || ",:;=}])({[/#，：".contains(c))
}

/// Whether what stands behind a quote ends a value or a key.
pub(super) fn ends_a_value(rest: &str) -> bool {
    let rest = rest.trim_start_matches([' ', '\t']);
    rest.is_empty() || rest.starts_with([',', ':', '}', ']', ')', ';', '=', '，', '：', '\n', '\r'])
}

/// What a character is that starts nothing.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// White space that JSON does not know.
    Space,
    /// What cannot be seen.
    Nothing,
    Other,
}

/// The class of such a character.
pub(super) fn class_of(c: char) -> Class {
    match c {
        '\u{feff}' => Class::Nothing,
        c if c.is_whitespace() => Class::Space,
        c if c.is_control() || escaped(c.encode_utf8(&mut [0; 4])).len() > 4 => Class::Nothing,
        _ => Class::Other,
    }
}
