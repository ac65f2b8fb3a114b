//! Expressions: the text under the key `expression`, as parts with their places in it. `docs/expressions.md` has the
//! grammar.

mod offsets;
mod parse;
mod syntax;
mod token;

#[cfg(test)]
mod tests;

pub(crate) use offsets::Offsets;
pub(crate) use parse::parse;
pub use parse::{MAX_EXPRESSION, MAX_EXPRESSION_DEPTH};
pub(crate) use syntax::{Argument, Mistake, Operator, Part, PartKind, Span};
