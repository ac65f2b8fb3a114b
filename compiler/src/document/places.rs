//! Places of values, with their JSON paths.

use crate::diagnostics::Place;

use super::{Document, Member, Value, ValueKind};

impl Value {
    /// What it is, with an article.
    pub fn describe(&self) -> String {
        match &self.kind {
            ValueKind::Null => "null".into(),
            ValueKind::Boolean(value) => value.to_string(),
            ValueKind::Number(text) if text.len() <= 24 => format!("the number {text}"),
            ValueKind::Number(_) => "a number".into(),
            ValueKind::String(text) if text.chars().count() <= 24 => format!("the string {text:?}"),
            ValueKind::String(_) => "a string".into(),
            ValueKind::Array(elements) => format!("a list of {}", elements.len()),
            ValueKind::Object(_) => "an object".into(),
        }
    }

    /// The members of an object; none for other values.
    pub fn members(&self) -> &[Member] {
        match &self.kind {
            ValueKind::Object(members) => members,
            _ => &[],
        }
    }

    /// The value of the first member called `key`.
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.members().iter().find(|member| member.key == key).map(|member| &member.value)
    }
}

impl Document {
    /// The place of a value.
    pub fn place(&self, value: &Value) -> Place {
        self.place_of_bytes(value.start, value.end)
    }

    /// The place of a member's key; its path is that of the member.
    pub fn place_of_key(&self, member: &Member) -> Place {
        self.place_of_bytes(member.key_start, member.key_end)
    }

    /// The place of a range of bytes; its path is that of the innermost value or member round it.
    pub fn place_of_bytes(&self, start: usize, end: usize) -> Place {
        Place { file: self.file.clone(), start, end, path: self.path_of_bytes(start, end) }
    }

    fn path_of_bytes(&self, start: usize, end: usize) -> String {
        let mut path = String::new();
        let mut value = self.written.as_deref().unwrap_or(&self.root);
        loop {
            // Members and elements stand in file order, so the one round a byte is found by halving.
            match &value.kind {
                ValueKind::Object(members) => {
                    let after = members.partition_point(|member| member.key_start <= start);
                    let Some(member) = after.checked_sub(1).map(|at| &members[at]) else { break };
                    if member.value.end < end || member.value.end <= start {
                        break;
                    }
                    push_key(&mut path, &member.key);
                    if member.value.start > start {
                        break;
                    }
                    value = &member.value;
                }
                ValueKind::Array(elements) => {
                    let after = elements.partition_point(|element| element.start <= start);
                    let Some(at) = after.checked_sub(1) else { break };
                    if elements[at].end < end || elements[at].end <= start {
                        break;
                    }
                    path.push_str(&format!("[{at}]"));
                    value = &elements[at];
                }
                _ => break,
            }
            if value.start == start && value.end == end {
                break;
            }
        }
        path
    }
}

fn push_key(path: &mut String, key: &str) {
    let plain =
        !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '$' | '-'));
    if plain {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(key);
    } else {
        path.push_str(&format!("[{key:?}]"));
    }
}
