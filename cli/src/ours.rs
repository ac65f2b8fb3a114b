//! Which JSON files are ours. An editor shows us all of them, and folders hold many: `package.json` is none of our
//! business. A file is ours by its own keys, whether it is whole or still being typed.

use phenomenon_compiler::document::{Document, ValueKind};

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ours {
    /// A graph, or one that lacks its name.
    Graph,
    /// A scene.
    Scene,
}

impl Ours {
    /// What a document is; none where it is neither.
    pub fn of(document: &Document) -> Option<Self> {
        let keys: Vec<(&str, char)> = document
            .root
            .members()
            .iter()
            .map(|member| {
                let first = match member.value.kind {
                    ValueKind::Object(_) => '{',
                    ValueKind::Array(_) => '[',
                    ValueKind::String(_) => '"',
                    _ => '0',
                };
                (member.key.as_str(), first)
            })
            .collect();
        Self::by_keys(&keys)
    }

    /// What a text is, which need not be JSON yet.
    pub fn of_text(text: &str) -> Option<Self> {
        let keys = outer_keys(text);
        let keys: Vec<(&str, char)> =
            keys.iter().map(|(key, first)| (key.as_str(), *first)).collect();
        Self::by_keys(&keys)
    }

    /// By the keys of the outermost object, each with the first character of its value. Other tools have keys
    /// `scene` (glTF: a number) and `roots` (jest: a list) too.
    fn by_keys(keys: &[(&str, char)]) -> Option<Self> {
        let has = |key: &str| keys.iter().any(|(known, _)| *known == key);
        let starts = |key: &str, with: char| keys.contains(&(key, with));
        if has("phenomenon") || starts("roots", '{') {
            return Some(Self::Graph);
        }
        let is_scene = has("scene") && (starts("scene", '"') || has("camera") && has("objects"));
        is_scene.then_some(Self::Scene)
    }
}

/// The keys of the outermost object, each with the first character of its value, a space where it has none.
fn outer_keys(text: &str) -> Vec<(String, char)> {
    let mut keys: Vec<(String, char)> = Vec::new();
    let mut depth = 0_usize;
    // Within the outermost object: whether a key is due, or a value.
    let (mut key_due, mut value_due) = (false, false);
    let mut characters = text.chars();
    while let Some(character) = characters.next() {
        if depth == 1 && value_due && !character.is_whitespace() {
            value_due = false;
            if let Some((_, first)) = keys.last_mut() {
                *first = character;
            }
        }
        match character {
            '{' | '[' => {
                depth += 1;
                key_due = depth == 1 && character == '{';
            }
            '}' | ']' => depth = depth.saturating_sub(1),
            ',' if depth == 1 => key_due = true,
            ':' if depth == 1 => value_due = true,
            '"' => {
                let mut string = String::new();
                while let Some(character) = characters.next() {
                    match character {
                        '"' => break,
                        '\\' => string.extend(characters.next()),
                        _ => string.push(character),
                    }
                }
                if depth == 1 && std::mem::take(&mut key_due) {
                    keys.push((string, ' '));
                }
            }
            _ => {}
        }
    }
    keys
}

#[cfg(test)]
mod tests {
    use phenomenon_compiler::document::read;

    use super::*;

    fn of(text: &str) -> Option<Ours> {
        let ours = Ours::of_text(text);
        if let Ok(document) = read("a.json", text.as_bytes()) {
            assert_eq!(Ours::of(&document), ours, "{text}");
        }
        ours
    }

    #[test]
    fn a_file_is_ours_by_its_own_keys() {
        for text in [
            r#"{ "phenomenon": "a" }"#,
            r#"{ "phenomenon": 5, "scene": "b" }"#,
            r#"{ "nodes": {}, "roots": { "material": 1 } }"#,
            r#"{ "roots": {} }"#,
            r#"{ "$schema": "x", "doc": "{[", "phenomenon": "a", "nodes": { "n": { "ty"#,
            r#"{ "phenomenon"#,
        ] {
            assert_eq!(of(text), Some(Ours::Graph), "{text}");
        }
        for text in [
            r#"{ "scene": "s" }"#,
            r#"{ "scene": 5, "camera": {}, "objects": [] }"#,
            r#"{ "doc": "\"", "scene": "s", "camera": { "pos"#,
        ] {
            assert_eq!(of(text), Some(Ours::Scene), "{text}");
        }
        for text in [
            r#"{ "name": "x", "version": "1.0.0", "dependencies": { "phenomenon": "^1", "scene": "2" } }"#,
            r#"{ "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "camera": 0 }], "asset": {} }"#,
            r#"{ "roots": ["<rootDir>/src"], "nodes": 1 }"#,
            r#"{ "a": [{ "phenomenon": 1 }], "b": "phenomenon" }"#,
            r#"["phenomenon", { "phenomenon": 1 }]"#,
            "",
            "{",
            "{}",
            "\"phenomenon\"",
            "}{]",
            "nul",
        ] {
            assert_eq!(of(text), None, "{text}");
        }
    }
}
