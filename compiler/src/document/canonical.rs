//! The canonical form of a file: the same values in the same order, laid out one way.

use serde_json::Value as Json;

use super::{Document, Member, Value, ValueKind};

/// Longest line a list or an object is kept on, in characters.
const WIDTH: usize = 120;
/// Most levels that are indented: deeper ones must still fit a line.
const INDENTED: usize = 20;

/// The document as text, two spaces a level. The order stays, but `format` comes first, after `$schema`. The file, its sections (`interface`, `nodes`,
/// `objects` …) and what they list have one line for each member; in what is listed, such as a node,
/// lines are filled up to 120 characters; a phenomenon within a file is laid out as a file is. Numbers stay as written, strings are escaped only where they
/// must be, and one blank line stays one.
pub fn canonical(document: &Document) -> String {
    let mut layout = Layout { source: &document.file.text, text: String::new(), line: 0 };
    layout.write(&document.root, At { depth: 0, level: 0 }, 0);
    layout.text.push('\n');
    layout.text
}

struct Layout<'d> {
    source: &'d str,
    text: String,
    /// Byte at which the last line starts.
    line: usize,
}

/// Where a value stands.
#[derive(Clone, Copy)]
struct At {
    /// How many objects and lists are round it.
    depth: usize,
    /// The same as far as the layout goes: a phenomenon within a file is laid out as the file is.
    level: usize,
}

impl At {
    /// What stands within a value, under that key of an object.
    fn within(self, member: Option<&Member>) -> Self {
        let level = match (self.level, member) {
            (0, Some(member)) if member.key == "phenomena" => PHENOMENA,
            (PHENOMENA, Some(_)) => 0,
            (PHENOMENA, None) => 2,
            (level, _) => level + 1,
        };
        Self { depth: self.depth + 1, level }
    }
}

/// The level of the section that has phenomena.
const PHENOMENA: usize = usize::MAX;

/// A key, for members of objects, and its value.
type Element<'v> = (Option<&'v Member>, &'v Value);

impl Layout<'_> {
    /// Writes a value; `after` characters follow on its last line.
    fn write(&mut self, value: &Value, at: At, after: usize) {
        let listed = match (at.level, &value.kind) {
            (0 | PHENOMENA, ValueKind::Object(members)) => !members.is_empty(),
            (1, ValueKind::Object(_)) => !is_short(value),
            _ => false,
        };
        if !listed && let Some(line) = one_line(value, self.room(after)) {
            self.text.push_str(&line);
            return;
        }
        let (elements, open, close): (Vec<Element<'_>>, _, _) = match &value.kind {
            ValueKind::Array(elements) => {
                (elements.iter().map(|it| (None, it)).collect(), "[", "]")
            }
            ValueKind::Object(members) => {
                let members =
                    if at.depth == 0 { in_order(members) } else { members.iter().collect() };
                (members.into_iter().map(|it| (Some(it), &it.value)).collect(), "{", "}")
            }
            // A leaf longer than a line is still one line.
            _ => return self.text.extend(one_line(value, usize::MAX)),
        };
        self.text.push_str(open);
        let of_leaves = |value: &Value| matches!(&value.kind, ValueKind::Array(elements) if elements.iter().all(is_leaf));
        if (at.level < 2 || at.level == PHENOMENA) && !of_leaves(value) {
            self.list(&elements, at);
            self.break_line(at.depth);
            self.text.push_str(close);
        } else {
            let close = if close == "}" { " }" } else { close };
            if open == "{" {
                self.text.push(' ');
            }
            self.fill(&elements, at, after + close.len());
            self.text.push_str(close);
        }
    }

    /// A line for each element.
    fn list(&mut self, elements: &[Element<'_>], within: At) {
        for (at, element) in elements.iter().enumerate() {
            if at > 0 {
                self.text.push(',');
                self.keep_blank_line(elements[at - 1], *element);
            }
            self.break_line(within.depth + 1);
            self.element(*element, within, usize::from(at + 1 < elements.len()));
        }
    }

    /// As many elements on a line as fit; the first stays on the line of the bracket. After an
    /// element of several lines the next one starts its own, where it is seen.
    fn fill(&mut self, elements: &[Element<'_>], within: At, after: usize) {
        let mut line = self.line;
        for (at, element) in elements.iter().enumerate() {
            let after = if at + 1 < elements.len() { 1 } else { after };
            if at > 0 {
                self.text.push(',');
                let blank = self.keep_blank_line(elements[at - 1], *element);
                if !blank && self.line == line && self.fits(*element, after) {
                    self.text.push(' ');
                } else {
                    self.break_line(within.depth + 1);
                }
            }
            line = self.line;
            self.element(*element, within, after);
        }
    }

    fn element(&mut self, (member, value): Element<'_>, within: At, after: usize) {
        if let Some(member) = member {
            self.text.push_str(&string(&member.key));
            self.text.push_str(": ");
        }
        self.write(value, within.within(member), after);
    }

    /// Whether a space, an element and `after` characters fit on the line.
    fn fits(&self, (member, value): Element<'_>, after: usize) -> bool {
        let key = member.map_or(0, |member| string(&member.key).chars().count() + 2);
        one_line(value, self.room(1 + key + after)).is_some()
    }

    /// Characters left on the line where `reserved` are already taken.
    fn room(&self, reserved: usize) -> usize {
        let line = &self.text[self.line..];
        // A line of very many bytes is past the width whatever its characters are.
        let taken = if line.len() > 4 * WIDTH { WIDTH } else { line.chars().count() };
        WIDTH.saturating_sub(taken + reserved)
    }

    /// Leaves an empty line where the source has some between two elements; whether it has.
    fn keep_blank_line(&mut self, (_, before): Element<'_>, (member, value): Element<'_>) -> bool {
        let start = member.map_or(value.start, |member| member.key_start);
        // Where one of the two has been moved, what stands between them in the source says nothing.
        let between = self.source.get(before.end..start).filter(|between| !between.contains('"'));
        let above = || &self.source[self.source[..start].trim_end().len()..start];
        let blank = between.unwrap_or_else(above).matches('\n').count() > 1;
        if blank {
            self.text.push('\n');
        }
        blank
    }

    fn break_line(&mut self, depth: usize) {
        self.text.push('\n');
        self.line = self.text.len();
        self.text.extend(std::iter::repeat_n(' ', 2 * depth.min(INDENTED)));
    }
}

/// The keys of a file in their order, but for `format`: it says how to read the others, so it comes before them, after
/// the `$schema` alone.
fn in_order(members: &[Member]) -> Vec<&Member> {
    let mut order: Vec<&Member> = members.iter().collect();
    let position = |key: &str| members.iter().position(|member| member.key == key);
    let is_ours = position("phenomenon").or(position("scene")).is_some();
    if let Some(from) = position("format").filter(|_| is_ours) {
        let format = order.remove(from);
        let schema = order.iter().position(|member| member.key == "$schema");
        order.insert(schema.map_or(0, |at| at + 1), format);
    }
    order
}

fn is_leaf(value: &Value) -> bool {
    !matches!(value.kind, ValueKind::Array(_) | ValueKind::Object(_))
}

/// Whether a section may stand on one line: it lists nothing, or one thing without parts.
fn is_short(section: &Value) -> bool {
    let is_object = |value: &Value| !value.members().is_empty();
    match section.members() {
        [one] => !one.value.members().iter().any(|part| is_object(&part.value)),
        members => !members.iter().any(|member| is_object(&member.value)),
    }
}

/// The value on one line; none where it is longer than `room`.
fn one_line(value: &Value, room: usize) -> Option<String> {
    let mut line = String::new();
    write_line(&mut line, value, room).then_some(line)
}

/// Writes a value on one line; false, and something unfinished, where it is longer than `room`.
fn write_line(line: &mut String, value: &Value, room: usize) -> bool {
    match &value.kind {
        ValueKind::Null => line.push_str("null"),
        ValueKind::Boolean(value) => line.push_str(if *value { "true" } else { "false" }),
        ValueKind::Number(number) => line.push_str(number),
        // So long a string is not copied for nothing on every level round it.
        ValueKind::String(value) if value.len() / 4 > room => return false,
        ValueKind::String(value) => line.push_str(&string(value)),
        ValueKind::Array(elements) => {
            line.push('[');
            for (at, element) in elements.iter().enumerate() {
                line.push_str(if at > 0 { ", " } else { "" });
                if !write_line(line, element, room) {
                    return false;
                }
            }
            line.push(']');
        }
        ValueKind::Object(members) => {
            line.push_str(if members.is_empty() { "{" } else { "{ " });
            for (at, member) in members.iter().enumerate() {
                line.push_str(if at > 0 { ", " } else { "" });
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
    fn phenomena_in_a_file_are_laid_out_as_files() {
        let text = "{\"phenomenon\":\"a\",\"phenomena\":{\"b\":{\"phenomena\":{\"c\":{}},\"nodes\":{\"n\":{\"type\":\"mix\"},\"m\":{\"type\":\"mix\",\"inputs\":{}}},\"outputs\":{\"x\":{\"type\":\"scalar\",\"from\":{\"node\":\"n\"}}}}},\"nodes\":{}}";
        let form = "{\n  \"phenomenon\": \"a\",\n  \"phenomena\": {\n    \"b\": {\n      \"phenomena\": {\n        \"c\": {}\n      },\n      \"nodes\": {\n        \"n\": { \"type\": \"mix\" },\n        \"m\": { \"type\": \"mix\", \"inputs\": {} }\n      },\n      \"outputs\": {\n        \"x\": { \"type\": \"scalar\", \"from\": { \"node\": \"n\" } }\n      }\n    }\n  },\n  \"nodes\": {}\n}\n";
        assert_eq!(format(text), form);
        assert_eq!(format(form), form);
    }

    #[test]
    fn one_blank_line_stays_one() {
        let text = "{\"nodes\": {\n\n\n\"a\": {},\n\"b\": {\"x\":2},\n\n\n\n\"c\": 3\n\n}}";
        let form =
            "{\n  \"nodes\": {\n    \"a\": {},\n    \"b\": { \"x\": 2 },\n\n    \"c\": 3\n  }\n}\n";
        assert_eq!(format(text), form);
        assert_eq!(format(form), form);
    }

    #[test]
    fn the_format_comes_before_what_it_is_of() {
        let text = "{\"phenomenon\":\"a\",\"$schema\":\"s\",\n\n\"doc\":\"\",\n\"format\":1,\n\"roots\":{}}";
        let form = "{\n  \"phenomenon\": \"a\",\n  \"$schema\": \"s\",\n  \"format\": 1,\n\n  \"doc\": \"\",\n  \"roots\": {}\n}\n";
        assert_eq!(format(text), form);
        assert_eq!(format(form), form);
        let text = "{\"scene\":\"a\",\n\n\"format\":1,\"x\":2}";
        let form = "{\n  \"format\": 1,\n  \"scene\": \"a\",\n  \"x\": 2\n}\n";
        assert_eq!(format(text), form);
        // Whatever is no graph and no scene has keys of its own.
        let foreign = "{\n  \"x\": 2,\n  \"format\": 1\n}\n";
        assert_eq!(format(foreign), foreign);
    }

    #[test]
    fn lines_are_filled_to_the_last_character() {
        // What is listed in a section is one line where it fits, its comma included.
        let with = |doc: usize, more: &str| {
            let doc = "é".repeat(doc);
            format!(
                "{{\"nodes\":{{\"n\":{{\"type\":\"mix\",\"inputs\":{{\"a\":[1]}},\"doc\":\"{doc}\"}}{more}}}}}"
            )
        };
        let line = r#"    "n": { "type": "mix", "inputs": { "a": [1] }, "doc": "" }"#;
        let room = WIDTH - line.chars().count();
        assert_eq!(format(&with(room, "")).lines().count(), 5);
        assert_eq!(format(&with(room + 1, "")).lines().count(), 6);
        assert_eq!(format(&with(room - 1, ",\"m\":{\"x\":{}}")).lines().count(), 6);
        assert_eq!(format(&with(room, ",\"m\":{\"x\":{}}")).lines().count(), 7);
        let form = format(&with(room + 1, ""));
        assert_eq!(
            form.lines().nth(3),
            Some(&*format!("      \"doc\": \"{}\" }}", "é".repeat(room + 1)))
        );
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
            &format!(
                "{{\"a\":{{\"b\":{{\"c\":{}}}}}}}",
                "[1,[2,3],{\"k\":".repeat(8) + "\"é\"" + &"}]".repeat(8)
            ),
        ] {
            let once = format(text);
            assert_eq!(format(&once), once);
            let plain = |text: &str| serde_json::from_str::<Json>(text).unwrap();
            assert_eq!(plain(&once), plain(text));
            assert!(once.lines().all(|line| line.chars().count() <= WIDTH), "{once}");
        }
    }
}
