//! What a terminal must not be sent as it is.

use std::borrow::Cow;
use std::fmt::Write;

use phenomenon_compiler::diagnostics::is_deceptive;

use super::look::Look;

/// The text with what cannot be seen written as `\u{202e}`, as messages have it. Line breaks and tabs stay.
pub fn shown<'t>(text: &'t str, look: &Look) -> Cow<'t, str> {
    let stays = |character: char| {
        matches!(character, '\n' | '\t')
            || !(is_deceptive(character) || look.ascii && !character.is_ascii())
    };
    if text.chars().all(stays) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if matches!(character, '\n' | '\t') {
            shown.push(character);
        } else {
            pushed(&mut shown, character, look);
        }
    }
    Cow::Owned(shown)
}

/// Appends a character, or what is shown in its place.
pub fn pushed(into: &mut String, character: char, look: &Look) {
    let unseen = is_deceptive(character);
    if !unseen && (character.is_ascii() || !look.ascii) {
        into.push(character);
    } else if let Some(plain) = plain(character).filter(|_| !unseen) {
        into.push_str(plain);
    } else {
        let _ = write!(into, "\\u{{{:x}}}", u32::from(character));
    }
}

/// The text with what cannot be seen as escapes of JSON, which are the same value in a string of JSON. Line breaks and
/// tabs stay.
pub fn json_shown(text: &str) -> Cow<'_, str> {
    let stays = |character: char| matches!(character, '\n' | '\t') || !is_deceptive(character);
    if text.chars().all(stays) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if stays(character) {
            shown.push(character);
        } else {
            for unit in character.encode_utf16(&mut [0; 2]) {
                let _ = write!(shown, "\\u{unit:04x}");
            }
        }
    }
    Cow::Owned(shown)
}

/// What our own texts use beyond ASCII, for terminals that cannot show it.
fn plain(character: char) -> Option<&'static str> {
    Some(match character {
        '…' => "...",
        '–' | '—' => "-",
        '·' => "*",
        '×' => "x",
        '→' => "->",
        '‘' | '’' => "'",
        '“' | '”' => "\"",
        '²' => "^2",
        'π' => "pi",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(ascii: bool) -> Look {
        Look { color: false, ascii, dumb: false, width: 80, wraps: false }
    }

    #[test]
    fn what_cannot_be_seen_is_escaped() {
        let text = "a\u{1b}[31m\u{7}\r\u{9b}\u{202e}\u{200b}\u{feff}\u{e0041}é😀e\u{301}\n\tb";
        let told = shown(text, &look(false));
        assert_eq!(
            told,
            "a\\u{1b}[31m\\u{7}\\u{d}\\u{9b}\\u{202e}\\u{200b}\\u{feff}\\u{e0041}é😀e\u{301}\n\tb"
        );
        assert_eq!(shown(&told, &look(false)), told);
    }

    #[test]
    fn json_keeps_its_value() {
        let string = format!("\"{}\"", "x\u{202e}\u{7f}\u{e0041}é");
        let escaped = json_shown(&string);
        assert_eq!(escaped, "\"x\\u202e\\u007f\\udb40\\udc41é\"");
        let value = |text: &str| serde_json::from_str::<String>(text).unwrap();
        assert_eq!(value(&escaped), value(&string));
    }

    #[test]
    fn what_can_be_seen_stays() {
        let text = "plain, é, 語, 😀, e\u{301}, ✓️ `a.b` {\"x\": 1}\n";
        assert!(matches!(shown(text, &look(false)), Cow::Borrowed(same) if same == text));
    }

    #[test]
    fn terminals_of_ascii_get_ascii() {
        assert_eq!(shown("add `…` → é😀", &look(true)), "add `...` -> \\u{e9}\\u{1f600}");
    }
}
