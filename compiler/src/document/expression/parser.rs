//! The state of an expression that is being read, and how it goes on behind a mistake: what is told, and what is passed
//! over so that nothing is told that only follows from it.

use super::token::{self, Token, Unknown};
use super::{Mistake, Part, Span};

/// How deep brackets, signs before a value and choices may be nested.
pub const MAX_EXPRESSION_DEPTH: usize = 64;

/// Words that are no names; the first two are operators between two values.
pub(crate) const WORDS: [&str; 5] = ["and", "or", "not", "true", "false"];

/// Most mistakes that are told of one expression.
const MAX_MISTAKES: usize = 10;

/// What a value stands in, which says what may stand behind it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Within {
    /// The whole text.
    Text,
    /// `( … )`.
    Brackets,
    /// The brackets of a call.
    Arguments,
    /// Between `?` and `:`.
    Choice,
}

/// An expression that is being read, and what is wrong with it so far.
pub(super) struct Parser<'t> {
    pub text: &'t str,
    /// The next token, and its place.
    pub token: Token,
    pub span: Span,
    /// Past the last token that was taken.
    pub end: usize,
    pub depth: usize,
    pub parts: Vec<Part>,
    pub mistakes: Vec<Mistake>,
    /// Where the token starts that was told of last, or that stands behind what was.
    pub told: Option<usize>,
    /// Whether a bracket was told to be open: those round it are, too.
    pub open_told: bool,
    /// Whether nothing more is told.
    pub stopped: bool,
}

impl<'t> Parser<'t> {
    pub fn new(text: &'t str) -> Self {
        Self {
            text,
            token: Token::End,
            span: 0..0,
            end: 0,
            depth: 0,
            parts: Vec::new(),
            mistakes: Vec::new(),
            told: None,
            open_told: false,
            stopped: false,
        }
    }

    /// Takes the next token; gives its place.
    pub fn take(&mut self) -> Span {
        let span = self.span.clone();
        self.end = span.end;
        self.advance(span.end);
        span
    }

    pub fn is(&self, sign: &str) -> bool {
        matches!(&self.token, Token::Sign(found) if *found == sign)
    }

    /// Reads the token that begins at `at`, or the one meant by what stands there.
    pub fn advance(&mut self, mut at: usize) {
        // What means nothing is told once, however many such characters there are in a row.
        let mut passed = false;
        loop {
            match token::next(self.text, at) {
                Ok((token, span)) => {
                    (self.token, self.span) = (token, span);
                    break;
                }
                Err(Unknown { mistake, meant: Some((token, span)) }) => {
                    (self.token, self.span) = (token, span);
                    self.tell(*mistake);
                    return;
                }
                Err(Unknown { mistake, meant: None }) => {
                    at = mistake.span.end;
                    self.span = mistake.span.clone();
                    if !std::mem::replace(&mut passed, true) {
                        self.tell(*mistake);
                    }
                }
            }
        }
        if passed {
            self.told = Some(self.span.start);
        }
        if self.stopped {
            (self.token, self.span) = (Token::End, self.text.len()..self.text.len());
        }
    }

    /// Tells of a mistake found at the next token, unless something was told there already.
    pub fn tell(&mut self, mistake: Mistake) {
        if self.stopped || self.told.replace(self.span.start) == Some(self.span.start) {
            return;
        }
        self.mistakes.push(mistake);
        if self.mistakes.len() == MAX_MISTAKES {
            self.stop();
        }
    }

    fn stop(&mut self) {
        self.stopped = true;
        (self.token, self.span) = (Token::End, self.text.len()..self.text.len());
    }

    /// Nothing is read of what is nested too deep.
    pub fn too_deep(&mut self) {
        let message = format!("the expression is nested more than {MAX_EXPRESSION_DEPTH} deep");
        let help = "put a part of it under `where`";
        self.tell(Mistake::new(self.span.clone(), message, help));
        self.stop();
    }

    /// A mistake at the next token: what was expected in its place.
    pub fn expected(&mut self, what: &str, help: impl Into<String>) {
        let message = format!("expected {what}, found {}", self.token.describe());
        // At the end there is nothing to point at but what stands before it.
        let span = match self.token {
            Token::End => {
                let last = self.text[..self.end].chars().next_back().map_or(0, char::len_utf8);
                self.end - last..self.end
            }
            _ => self.span.clone(),
        };
        self.tell(Mistake::new(span, message, help));
    }

    /// Tells that the next token begins no value.
    pub fn no_value(&mut self) {
        let Token::Name(word) = &self.token else {
            return self.expected("a value", "a value is a number, a name, a function or `( … )`");
        };
        let help = format!(
            "`{word}` is an operator; bind what is called so to another name under `where`"
        );
        self.expected("a value", help);
        self.take();
        self.told = Some(self.span.start);
    }

    /// Takes the `)` of a bracket that was opened, or tells that it is missing.
    pub fn close(&mut self, open: Span) {
        if self.is(")") {
            self.take();
        } else if !self.stopped && !std::mem::replace(&mut self.open_told, true) {
            self.mistakes.push(Mistake::new(open, "this `(` is never closed", "add a `)`"));
        }
    }

    /// A value up to the end of what it stands in. What neither is a part of it nor ends it is told of, and passed over.
    pub fn enclosed(&mut self, within: Within) -> usize {
        let mut part = self.value(0);
        let mut told: Vec<String> = Vec::new();
        while !self.ends(within) {
            // Of values side by side, and of commas, the first is told.
            let found = if self.begins_value() { String::new() } else { self.token.describe() };
            if told.contains(&found) {
                self.told = Some(self.span.start);
            } else {
                let mistake = self.surplus(within);
                self.tell(mistake);
                told.push(found);
            }
            if !self.begins_value() {
                self.take();
                // What follows from it is not told.
                self.told = Some(self.span.start);
                part = self.continued(part, 0);
            }
            if self.begins_value() {
                part = self.value(0);
            }
        }
        part
    }

    fn ends(&self, within: Within) -> bool {
        self.token == Token::End
            || match within {
                Within::Text => false,
                Within::Brackets => self.is(")"),
                Within::Arguments => self.is(")") || self.is(","),
                Within::Choice => self.is(":") || self.is(")") || self.is(","),
            }
    }

    /// Whether a value begins here, where an operator was due.
    fn begins_value(&self) -> bool {
        match &self.token {
            Token::Number(_) | Token::Text(_) => true,
            Token::Name(name) => !WORDS[..2].contains(&name.as_str()),
            Token::Sign(sign) => matches!(*sign, "(" | "!"),
            Token::End => false,
        }
    }

    /// What is said of a token behind a value.
    fn surplus(&self, within: Within) -> Mistake {
        let (span, found) = (self.span.clone(), self.token.describe());
        let several = "write `vector(x, y, z)` or `color(r, g, b)` for several numbers";
        match (&self.token, within) {
            (Token::Sign(")"), _) => {
                Mistake::new(span, "this `)` closes nothing", "remove it, or add a `(`")
            }
            (Token::Sign("]"), _) => {
                Mistake::new(span, "this `]` closes nothing", "remove it, or add a `[`")
            }
            (Token::Sign(":"), _) => {
                Mistake::new(span, "this `:` has no `?`", "write `condition ? one : other`")
            }
            (Token::Sign(","), _) => Mistake::new(span, "an expression is one value", several),
            (_, Within::Arguments) => {
                let message = format!("expected `,` or `)`, found {found}");
                Mistake::new(span, message, "arguments are parted by `,`")
            }
            (_, Within::Brackets) => {
                let message = format!("expected an operator or `)`, found {found}");
                let help = "put an operator between two values, or close the bracket";
                Mistake::new(span, message, help)
            }
            _ => {
                let message = format!("expected an operator, found {found}");
                Mistake::new(span, message, "put an operator such as `*` between the two values")
            }
        }
    }

    /// Passes over what stands between square brackets, the first of which was taken.
    pub fn skip_list(&mut self) {
        let mut depth = 1;
        while depth > 0 && self.token != Token::End {
            if self.is("[") {
                depth += 1;
            } else if self.is("]") {
                depth -= 1;
            } else if depth == 1 && self.is(")") {
                break;
            }
            self.take();
        }
        self.told = Some(self.span.start);
    }
}
