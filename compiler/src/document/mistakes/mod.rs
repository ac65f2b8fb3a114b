//! All mistakes of a file that is no JSON. The strict parser judges files and stops at what it meets
//! first; this scan is never asked of a file that is right. It tolerates what it can name, so that one
//! run tells every mistake and nothing that only follows from one.
//!
//! It reads the text three times, each time in one pass and with a bounded stack: to count brackets, to
//! find by indentation which are missing or too many, and to follow the grammar.

mod brackets;
mod characters;
mod corrections;
mod elements;
mod grammar;
mod lexer;
mod matching;
mod members;
mod mistake;
mod quotes;
mod scan;
mod standing;
mod strings;
mod tokens;
mod words;

pub use brackets::MAX_BRACKETS;
pub use mistake::MAX_MISTAKES;
pub(super) use scan::all;
