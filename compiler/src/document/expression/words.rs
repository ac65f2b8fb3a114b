//! The names in the text of an expression, whatever state it is in: for editors.

use std::ops::Range;

use super::parser::WORDS;
use super::token::{self, Token, Unknown};
use super::{Offsets, Span};
use crate::document::{Document, Value, ValueKind};

/// What a name in an expression stands for, as its neighbours say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// A node, a parameter, or what `where` binds.
    Value,
    /// A function.
    Function,
    /// The argument of a function, by name.
    Argument {
        /// The function.
        function: String,
    },
    /// What stands behind a `.`.
    Member {
        /// The name before it, where that is all that stands there.
        of: Option<String>,
    },
}

/// A name in an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The name.
    pub name: String,
    /// What it stands for.
    pub role: Role,
    /// Its bytes in the text.
    pub span: Range<usize>,
}

/// The names in a text, in its order.
pub fn words(text: &str) -> Vec<Word> {
    let tokens = tokens(text);
    let mut words: Vec<Word> = Vec::new();
    // The functions whose brackets are open; none for brackets that are no calls.
    let mut calls: Vec<Option<String>> = Vec::new();
    let sign = |at: Option<usize>, is: &[&str]| {
        at.and_then(|at| tokens.get(at))
            .is_some_and(|(token, _)| matches!(token, Token::Sign(found) if is.contains(found)))
    };
    for (at, (token, span)) in tokens.iter().enumerate() {
        let before = at.checked_sub(1);
        match token {
            Token::Sign("(") => {
                let last = words.last().filter(|word| word.role == Role::Function);
                let name =
                    last.filter(|word| Some(word.span.end) == before.map(|at| tokens[at].1.end));
                calls.push(name.map(|word| word.name.clone()));
            }
            Token::Sign(")") => {
                calls.pop();
            }
            Token::Name(name) => {
                let role = if sign(before, &["."]) {
                    let of = at.checked_sub(2).map(|at| &tokens[at].0);
                    let alone = !sign(at.checked_sub(3), &["."]);
                    let of = match of {
                        Some(Token::Name(of)) if alone => Some(of.clone()),
                        _ => None,
                    };
                    Role::Member { of }
                } else if WORDS.contains(&name.as_str()) {
                    continue;
                } else if sign(Some(at + 1), &["("]) {
                    Role::Function
                } else if sign(Some(at + 1), &[":"])
                    && sign(before, &["(", ","])
                    && let Some(Some(function)) = calls.last()
                {
                    Role::Argument { function: function.clone() }
                } else {
                    Role::Value
                };
                words.push(Word { name: name.clone(), role, span: span.clone() });
            }
            _ => {}
        }
    }
    words
}

/// Its tokens; what means nothing is passed over.
fn tokens(text: &str) -> Vec<(Token, Span)> {
    let mut tokens = Vec::new();
    let mut at = 0;
    loop {
        let (token, span) = match token::next(text, at) {
            Ok((Token::End, _)) => return tokens,
            Ok(found) => found,
            Err(Unknown { meant: Some(found), .. }) => found,
            Err(Unknown { mistake, .. }) => {
                at = mistake.span.end;
                continue;
            }
        };
        at = span.end;
        tokens.push((token, span));
    }
}

/// The names in the text of an expression of a document, with their bytes in the file.
pub fn words_in(document: &Document, text: &Value) -> Vec<(Word, Range<usize>)> {
    let ValueKind::String(written) = &text.kind else { return Vec::new() };
    let offsets = Offsets::of(&document.file.text, text.start, text.end);
    let placed = words(written).into_iter().map(|word| {
        let (start, end) = offsets.place(&word.span);
        (word, start..end)
    });
    placed.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_the_roles_their_neighbours_say() {
        let told = |text: &str| {
            let word = |word: Word| match word.role {
                Role::Value => word.name,
                Role::Function => format!("{}()", word.name),
                Role::Argument { function } => format!("{function}({}:)", word.name),
                Role::Member { of } => format!("{}.{}", of.unwrap_or_default(), word.name),
            };
            words(text).into_iter().map(word).collect::<Vec<String>>().join(" ")
        };
        for (text, expected) in [
            ("mix(weight: a, b: s.u) * t.r", "mix() mix(weight:) a mix(b:) s s.u t t.r"),
            ("(a ? b : c) and not d", "a b c d"),
            ("layers[1].tint.r", "layers .tint .r"),
            ("f(g(x), y: 1).xyz + ", "f() g() x f(y:) .xyz"),
            ("a.b.c $d 2x ^ \u{1F600} e 'unclosed", "a a.b .c d e"),
            ("(a: b", "a b"),
            ("", ""),
        ] {
            assert_eq!(told(text), expected, "{text}");
        }
    }
}
