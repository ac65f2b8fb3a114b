//! Expressions: the text under the key `expression`, as parts with their places in it. `docs/expressions.md` has the
//! grammar.

mod offsets;
mod parse;
mod parser;
mod syntax;
mod token;
mod words;

#[cfg(test)]
mod tests;

pub(crate) use offsets::Offsets;
pub use parse::MAX_EXPRESSION;
pub(crate) use parse::parse;
pub use parser::MAX_EXPRESSION_DEPTH;
pub(crate) use parser::WORDS;
pub(crate) use syntax::{Argument, Mistake, Operator, Part, PartKind, Span};
pub use words::{Role, Word, words, words_in};
