//! JSON as written: every key and value with its place in the file.
//!
//! It is strict JSON (RFC 8259) in UTF-8. It keeps duplicate keys, so that the checker can
//! report them, and numbers as written.

mod canonical;
mod format;
mod mistakes;
pub mod numbers;
mod open;
mod places;
mod prescan;
mod read;
mod reader;
mod suggest;
mod syntax;

use std::sync::Arc;

use crate::diagnostics::SourceFile;

pub use crate::diagnostics::listed;
pub(crate) use crate::diagnostics::shortened;
pub use canonical::canonical;
pub use format::FORMAT;
pub(crate) use open::irregular;
pub use open::{open_file, opened_files};
pub use prescan::{MAX_DEPTH, MAX_FILE_BYTES, MAX_VALUES};
pub use read::{all_mistakes, read, read_file, read_from};
pub(crate) use reader::shown;
pub use reader::{Object, Reader};
pub(crate) use suggest::advice;
pub use suggest::{Suggestion, nearest};

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
}
