//! Where in a file the cursor stands. What one types is hardly ever JSON, so the text before the
//! cursor is scanned for brackets, keys and strings only.

use std::collections::HashMap;

/// Where the cursor stands.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Cursor {
    /// Keys from the outermost object to the innermost; a list has the key of the one it is in.
    pub path: Vec<String>,
    /// Whether a key of the innermost object is being written, not a value.
    pub at_key: bool,
    /// What is written of the string the cursor is in; none outside of strings.
    pub written: Option<String>,
    /// Strings of the innermost object before the cursor, by key.
    pub siblings: HashMap<String, String>,
    /// The same of the objects round it, outermost first.
    pub around: Vec<HashMap<String, String>>,
}

/// An open bracket.
#[derive(Default)]
struct Open {
    is_object: bool,
    key: Option<String>,
    /// Whether the next string is a key.
    before_key: bool,
    strings: HashMap<String, String>,
}

impl Cursor {
    /// The cursor after `text`.
    pub fn after(text: &str) -> Self {
        let mut open: Vec<Open> = Vec::new();
        let mut characters = text.chars();
        let mut written = None;
        while let Some(character) = characters.next() {
            match character {
                '{' | '[' => {
                    let is_object = character == '{';
                    open.push(Open { is_object, before_key: is_object, ..Open::default() });
                }
                '}' | ']' => {
                    open.pop();
                }
                ',' => {
                    if let Some(open) = open.last_mut() {
                        open.before_key = open.is_object;
                    }
                }
                ':' => {
                    if let Some(open) = open.last_mut() {
                        open.before_key = false;
                    }
                }
                '"' => {
                    let (string, closed) = string(&mut characters);
                    if !closed {
                        written = Some(string);
                        break;
                    }
                    let Some(open) = open.last_mut().filter(|open| open.is_object) else {
                        continue;
                    };
                    match (&open.key, open.before_key) {
                        (_, true) => open.key = Some(string),
                        (Some(key), false) => {
                            open.strings.insert(key.clone(), string);
                        }
                        (None, false) => {}
                    }
                }
                _ => {}
            }
        }
        let at_key = open.last().is_some_and(|open| open.before_key);
        let depth = open.len();
        let mut path = Vec::new();
        let mut around = Vec::new();
        for (at, open) in open.into_iter().enumerate() {
            if let Some(key) = open.key
                && !(at + 1 == depth && at_key)
            {
                path.push(key);
            }
            around.push(open.strings);
        }
        let siblings = around.pop().unwrap_or_default();
        Self { path, at_key, written, siblings, around }
    }
}

/// The rest of a string, and whether its closing quote came. Escapes stay as they are but for their
/// backslash: names have none.
fn string(characters: &mut std::str::Chars<'_>) -> (String, bool) {
    let mut string = String::new();
    while let Some(character) = characters.next() {
        match character {
            '"' => return (string, true),
            '\\' => string.extend(characters.next()),
            _ => string.push(character),
        }
    }
    (string, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_values_are_told_apart() {
        let cursor = Cursor::after(r#"{ "nodes": { "a": { "type": "mix", "inputs": { "we"#);
        assert_eq!(cursor.path, ["nodes", "a", "inputs"]);
        assert!(cursor.at_key);
        assert_eq!(cursor.written.as_deref(), Some("we"));
        assert_eq!(cursor.around[2]["type"], "mix");
        let cursor = Cursor::after(r#"{ "roots": { "material": { "node": "a", "output": ""#);
        assert_eq!(cursor.path, ["roots", "material", "output"]);
        assert!(!cursor.at_key);
        assert_eq!(cursor.siblings["node"], "a");
    }

    #[test]
    fn what_is_no_json_is_survived() {
        for text in
            ["", "}", "]]", "\"", "{\"a\\", "{:,:", "[1, {\"x\"", "{\"a\": \"\\\"", "é\u{0}"]
        {
            Cursor::after(text);
        }
        assert_eq!(Cursor::after("{\"a\": [1, \"x").path, ["a"]);
    }
}
