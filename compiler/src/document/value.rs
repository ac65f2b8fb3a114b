//! Values and members with their places in the file.

use std::sync::Arc;

use crate::diagnostics::SourceFile;

/// A value with its place, as byte range of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// First byte.
    pub start: usize,
    /// Past the last byte.
    pub end: usize,
    /// What it is.
    pub kind: ValueKind,
}

/// What a value is.
#[derive(Clone, Debug, PartialEq)]
pub enum ValueKind {
    /// `null`
    Null,
    /// `true` or `false`
    Boolean(bool),
    /// A number, as written.
    Number(String),
    /// A string, escapes resolved.
    String(String),
    /// A list.
    Array(Vec<Value>),
    /// An object, in file order, duplicate keys included.
    Object(Vec<Member>),
}

/// A key with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The key, escapes resolved.
    pub key: String,
    /// First byte of the key, its quote included.
    pub key_start: usize,
    /// Past the last byte of the key.
    pub key_end: usize,
    /// The value.
    pub value: Value,
}

/// A file that was read.
#[derive(Clone, Debug)]
pub struct Document {
    /// The file.
    pub file: Arc<SourceFile>,
    /// Its one value.
    pub root: Value,
    /// That value as the file has it, where `root` is what was made of it: places are found there.
    pub written: Option<Arc<Value>>,
}
