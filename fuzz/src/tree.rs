//! Documents as trees to be changed, and as text again.

use std::fmt::Write;

use phenomenon_compiler::document::{Member, Value, ValueKind};

/// The number of values in a tree.
pub fn count(value: &Value) -> usize {
    1 + match &value.kind {
        ValueKind::Array(elements) => elements.iter().map(count).sum(),
        ValueKind::Object(members) => members.iter().map(|member| count(&member.value)).sum(),
        _ => 0,
    }
}

/// The value at a position, counted from the root in file order.
pub fn at<'v>(value: &'v mut Value, position: &mut usize) -> Option<&'v mut Value> {
    if *position == 0 {
        return Some(value);
    }
    *position -= 1;
    match &mut value.kind {
        ValueKind::Array(elements) => elements.iter_mut().find_map(|it| at(it, position)),
        ValueKind::Object(members) => {
            members.iter_mut().find_map(|member| at(&mut member.value, position))
        }
        _ => None,
    }
}

/// Every string and key of a tree.
pub fn strings<'v>(value: &'v Value, found: &mut Vec<&'v str>) {
    match &value.kind {
        ValueKind::String(text) => found.push(text),
        ValueKind::Array(elements) => elements.iter().for_each(|it| strings(it, found)),
        ValueKind::Object(members) => {
            for member in members {
                found.push(&member.key);
                strings(&member.value, found);
            }
        }
        _ => {}
    }
}

/// A value without a place.
pub fn value(kind: ValueKind) -> Value {
    Value { start: 0, end: 0, kind }
}

/// A member without a place.
pub fn member(key: &str, value: Value) -> Member {
    Member { key: key.to_owned(), key_start: 0, key_end: 0, value }
}

/// The tree as JSON.
pub fn write(value: &Value, text: &mut String) {
    match &value.kind {
        ValueKind::Null => text.push_str("null"),
        ValueKind::Boolean(value) => text.push_str(if *value { "true" } else { "false" }),
        ValueKind::Number(number) => text.push_str(number),
        ValueKind::String(value) => push_string(value, text),
        ValueKind::Array(elements) => {
            text.push('[');
            for (at, element) in elements.iter().enumerate() {
                text.push_str(if at > 0 { ", " } else { "" });
                write(element, text);
            }
            text.push(']');
        }
        ValueKind::Object(members) => {
            text.push('{');
            for (at, member) in members.iter().enumerate() {
                text.push_str(if at > 0 { ",\n" } else { "" });
                push_string(&member.key, text);
                text.push_str(": ");
                write(&member.value, text);
            }
            text.push('}');
        }
    }
}

fn push_string(value: &str, text: &mut String) {
    let _ = write!(text, "{}", serde_json::Value::from(value));
}
