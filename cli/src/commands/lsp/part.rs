//! An input or an output, whoever declares it.

use phenomenon_compiler::document::{Value, ValueKind};

/// An input or an output.
#[derive(Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its type.
    pub of: String,
    /// Its doc, with its range.
    pub doc: String,
    /// The names it may be given, where it is a choice.
    pub choices: Vec<String>,
}

/// The string under a key.
pub fn text<'f>(value: &'f Value, key: &str) -> Option<&'f str> {
    match &value.get(key)?.kind {
        ValueKind::String(text) => Some(text),
        _ => None,
    }
}
