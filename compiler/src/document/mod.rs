//! JSON as written: every key and value with its place in the file.
//!
//! It is strict JSON (RFC 8259) in UTF-8. It keeps duplicate keys, so that the checker can
//! report them, and numbers as written. What keys the objects of a format have, tables say: a `Section` for each.

mod canonical;
pub(crate) mod expression;
mod format;
mod mistakes;
pub mod numbers;
mod open;
mod places;
mod prescan;
mod read;
mod reader;
mod section;
mod syntax;
mod value;

pub use canonical::canonical;
pub use expression::{MAX_EXPRESSION, MAX_EXPRESSION_DEPTH, Role, Word, words, words_in};
pub use format::FORMAT;
pub(crate) use format::is_newer_format;
pub use mistakes::{MAX_BRACKETS, MAX_MISTAKES};
pub(crate) use open::irregular;
pub use open::{open_file, opened_files};
pub use prescan::{MAX_DEPTH, MAX_FILE_BYTES, MAX_VALUES};
pub use read::{all_mistakes, read, read_file, read_from};
pub use reader::{Object, Reader};
pub use section::{GRAPH_FILES, Given, Key, Kind, MESH_FILES, PICTURE_FILES, Section, names_of};
pub use value::{Document, Member, Value, ValueKind};
