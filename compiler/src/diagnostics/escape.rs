//! Text of users within messages: what could hide or reorder what is read is written as an escape.

use std::borrow::Cow;
use std::fmt::Write;

/// The text with control characters, direction marks and characters without width written as
/// `\u{202e}`: a name cannot move the cursor of a terminal, nor pass itself off as another one.
pub fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(is_deceptive) {
        return Cow::Borrowed(text);
    }
    let mut safe = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '\n' => safe.push_str("\\n"),
            '\r' => safe.push_str("\\r"),
            '\t' => safe.push_str("\\t"),
            c if is_deceptive(c) => {
                let _ = write!(safe, "\\u{{{:x}}}", u32::from(c));
            }
            c => safe.push(c),
        }
    }
    Cow::Owned(safe)
}

/// Whether a character does something else than show itself: a terminal acts on it, it reorders what
/// stands round it (Unicode Standard Annex 9), or nothing of it is seen.
pub fn is_deceptive(character: char) -> bool {
    character.is_control()
        || matches!(character,
            // Marks of direction, embeddings, overrides and isolates.
            '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{206f}'
            // Of no width: spaces, joiners, byte order marks, operators, soft hyphens.
            | '\u{00ad}' | '\u{034f}' | '\u{180b}'..='\u{180f}' | '\u{200b}'..='\u{200d}'
            | '\u{2060}'..='\u{2065}' | '\u{feff}' | '\u{fff0}'..='\u{fffb}'
            // Letters that are drawn as nothing.
            | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{3164}' | '\u{ffa0}'
            // Breaks of lines and paragraphs.
            | '\u{2028}' | '\u{2029}'
            // Tags and selectors of variants, beats and shorthand.
            | '\u{e0000}'..='\u{e0fff}' | '\u{1bca0}'..='\u{1bca3}' | '\u{1d173}'..='\u{1d17a}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_shows_itself_stays_and_what_does_not_is_named() {
        for plain in ["", "shade", "näme \"x\" \\n", "材質", "😀", "a b"] {
            assert!(matches!(escaped(plain), Cow::Borrowed(same) if same == plain));
        }
        for (text, shown) in [
            ("a\u{1b}[31mb", "a\\u{1b}[31mb"),
            ("a\nb\tc\r", "a\\nb\\tc\\r"),
            ("\u{0}\u{7f}\u{9b}", "\\u{0}\\u{7f}\\u{9b}"),
            ("gnp.\u{202e}exe", "gnp.\\u{202e}exe"),
            ("\u{2066}x\u{2069}", "\\u{2066}x\\u{2069}"),
            ("to\u{200b}p\u{feff}", "to\\u{200b}p\\u{feff}"),
            ("é\u{2028}", "é\\u{2028}"),
        ] {
            assert_eq!(escaped(text), shown);
            assert_eq!(escaped(shown), shown, "once is enough");
        }
    }
}
