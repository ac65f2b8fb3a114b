//! The canonical form of a file: the same values in the same order, laid out one way.

use serde_json::Value as Json;

use super::{Document, Value, ValueKind};

/// Longest line a list or an object is kept on, in characters, its indentation included.
const WIDTH: usize = 100;

/// The document as text: two spaces a level, one member a line, but on one line what fits there
/// (except the file itself, `interface`, `nodes` and their like one level below it). Numbers stay
/// as written, strings are escaped only where they must be, and one blank line stays one.
pub fn canonical(document: &Document) -> String {
    let mut layout = Layout { source: &document.file.text, text: String::new() };
    layout.write(&document.root, 0, 0);
    layout.text.push('\n');
    layout.text
}

struct Layout<'d> {
    source: &'d str,
    text: String,
}

impl Layout<'_> {
    /// Writes a value at a nesting depth; `before` characters stand on its line already.
    fn write(&mut self, value: &Value, depth: usize, before: usize) {
        let keep_open = match (depth, &value.kind) {
            (0, ValueKind::Object(members)) => !members.is_empty(),
            (1, ValueKind::Object(_)) => !is_short(value),
            _ => false,
        };
        if !keep_open {
            let mut line = String::new();
            if write_line(&mut line, value, WIDTH.saturating_sub(before)) {
                self.text.push_str(&line);
                return;
            }
        }
        let indentation = 2 * (depth + 1);
        let mut end_of_last = None;
        match &value.kind {
            ValueKind::Array(elements) => {
                self.text.push('[');
                for element in elements {
                    self.start(indentation, end_of_last, element.start);
                    self.write(element, depth + 1, indentation + 1);
                    end_of_last = Some(element.end);
                }
            }
            ValueKind::Object(members) => {
                self.text.push('{');
                for member in members {
                    self.start(indentation, end_of_last, member.key_start);
                    let key = string(&member.key);
                    let before = indentation + key.chars().count() + 3;
                    self.text.push_str(&key);
                    self.text.push_str(": ");
                    self.write(&member.value, depth + 1, before);
                    end_of_last = Some(member.value.end);
                }
            }
            _ => {
                // A leaf longer than a line is still one line.
                write_line(&mut self.text, value, usize::MAX);
                return;
            }
        }
        self.text.push('\n');
        self.text.extend(std::iter::repeat_n(' ', 2 * depth));
        self.text.push(if matches!(value.kind, ValueKind::Array(_)) { ']' } else { '}' });
    }

    /// Starts the line of an element, after a blank one where the source has any.
    fn start(&mut self, indentation: usize, end_of_last: Option<usize>, start: usize) {
        if let Some(end) = end_of_last {
            self.text.push(',');
            if self.source[end..start].matches('\n').count() > 1 {
                self.text.push('\n');
            }
        }
        self.text.push('\n');
        self.text.extend(std::iter::repeat_n(' ', indentation));
    }
}

/// Whether an object one level below the file may stand on one line: it is empty, or one leaf,
/// connection or the like.
fn is_short(value: &Value) -> bool {
    let flat = |inner: &Value| inner.members().iter().all(|it| it.value.members().is_empty());
    match value.members() {
        [] => true,
        [one] => flat(&one.value),
        _ => false,
    }
}

/// Writes a value on one line; false, and something unfinished, where it is longer than `room`.
fn write_line(line: &mut String, value: &Value, room: usize) -> bool {
    match &value.kind {
        ValueKind::Null => line.push_str("null"),
        ValueKind::Boolean(value) => line.push_str(if *value { "true" } else { "false" }),
        ValueKind::Number(number) => line.push_str(number),
        ValueKind::String(value) => line.push_str(&string(value)),
        ValueKind::Array(elements) => {
            line.push('[');
            for (at, element) in elements.iter().enumerate() {
                if at > 0 {
                    line.push_str(", ");
                }
                if !write_line(line, element, room) {
                    return false;
                }
            }
            line.push(']');
        }
        ValueKind::Object(members) => {
            line.push_str(if members.is_empty() { "{" } else { "{ " });
            for (at, member) in members.iter().enumerate() {
                if at > 0 {
                    line.push_str(", ");
                }
                line.push_str(&string(&member.key));
                line.push_str(": ");
                if !write_line(line, &member.value, room) {
                    return false;
                }
            }
            line.push_str(if members.is_empty() { "}" } else { " }" });
        }
    }
    // Bytes first: characters are counted only where the bytes do not settle it.
    line.len() <= room || line.chars().count() <= room
}

fn string(value: &str) -> String {
    Json::from(value).to_string()
}

#[cfg(test)]
mod tests {
    use super::super::read;
    use super::*;

    fn format(text: &str) -> String {
        canonical(&read("a", text.as_bytes()).unwrap())
    }

    #[test]
    fn keeps_order_numbers_and_strings() {
        let text =
            "{\"b\":1.50e+2,\"a\":[ ],\"doc\":\"é\\u00e9\\n\\u0001\",\"editor\":{\"x\":-0.0}}";
        assert_eq!(
            format(text),
            "{\n  \"b\": 1.50e+2,\n  \"a\": [],\n  \"doc\": \"éé\\n\\u0001\",\n  \"editor\": { \"x\": -0.0 }\n}\n"
        );
    }

    #[test]
    fn one_blank_line_stays_one() {
        let text = "{\"nodes\": {\n\n\n\"a\": 1,\n\"b\": 2,\n\n\n\n\"c\": 3\n\n}}";
        let form = "{\n  \"nodes\": {\n    \"a\": 1,\n    \"b\": 2,\n\n    \"c\": 3\n  }\n}\n";
        assert_eq!(format(text), form);
        assert_eq!(format(form), form);
    }

    #[test]
    fn formatting_twice_changes_nothing_and_values_stay() {
        let long = format!(
            "{{\"nodes\":{{\"n\":{{\"type\":\"mix\",\"inputs\":{{\"a\":[{}]}}}},\"m\":{{}}}}}}",
            ["0.25"; 60].join(",")
        );
        for text in [
            long.as_str(),
            "[]",
            "1",
            "[[1,[2,{\"a\":{\"b\":[]}}]],\"x\"]",
            "{\"roots\":{\"material\":{\"node\":\"n\"}}}",
        ] {
            let once = format(text);
            assert_eq!(format(&once), once);
            let plain = |text: &str| serde_json::from_str::<Json>(text).unwrap();
            assert_eq!(plain(&once), plain(text));
            assert!(once.lines().all(|line| line.chars().count() <= WIDTH), "{once}");
        }
    }
}
