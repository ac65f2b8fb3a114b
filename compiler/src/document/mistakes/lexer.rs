//! Where reading of tokens stands, and what was noted on the way.

use super::mistake::{MAX_MISTAKES, Mistake};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `{`, `[` or `(`.
    Open(u8),
    /// `}`, `]` or `)`.
    Close(u8),
    Comma,
    /// `;` where a comma should be.
    Semicolon,
    Colon,
    /// `=` where a colon should be.
    Equals,
    String,
    /// A number, true, false, null, or what was meant as one.
    Value,
    /// Letters that are none of these.
    Word,
}

/// A token with its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub kind: Kind,
    pub start: usize,
    pub end: usize,
    /// Characters before it on its line, where it is the first one there.
    pub indent: Option<usize>,
    /// Its line, from 1.
    pub line: usize,
}

/// Reads tokens, and notes what is wrong within them.
pub(super) struct Lexer<'t> {
    pub text: &'t str,
    pub at: usize,
    pub mistakes: Vec<Mistake>,
    /// Whether mistakes are counted only.
    quiet: bool,
    pub told: usize,
    pub line: usize,
    pub line_start: usize,
    pub fresh: bool,
    /// Where the last comment ends: several in a row are one mistake.
    pub comment: Option<usize>,
    pub peeked: Option<Token>,
}

impl<'t> Lexer<'t> {
    pub fn new(text: &'t str, quiet: bool) -> Self {
        let mistakes = Vec::new();
        let (line, line_start, fresh) = (1, 0, true);
        let (comment, peeked) = (None, None);
        Self { text, at: 0, mistakes, quiet, told: 0, line, line_start, fresh, comment, peeked }
    }

    /// Whether there are so many mistakes that no more are looked for.
    pub fn is_full(&self) -> bool {
        self.told >= MAX_MISTAKES
    }

    pub fn tell(&mut self, mistake: Mistake) {
        self.told += 1;
        if !self.quiet {
            self.mistakes.push(mistake);
        }
    }

    pub fn byte(&self, at: usize) -> Option<u8> {
        self.text.as_bytes().get(at).copied()
    }

    pub fn character(&self, at: usize) -> Option<char> {
        self.text.get(at..)?.chars().next()
    }

    /// A token from a byte to where reading stands.
    pub fn token(&mut self, kind: Kind, start: usize) -> Token {
        let indent = self.fresh.then(|| start - self.line_start);
        self.fresh = false;
        Token { kind, start, end: self.at, indent, line: self.line }
    }

    /// Notes the line breaks up to where reading stands.
    pub fn count_lines(&mut self, from: usize) {
        let passed = &self.text.as_bytes()[from..self.at];
        for (at, _) in passed.iter().enumerate().filter(|(_, byte)| **byte == b'\n') {
            self.line += 1;
            self.line_start = from + at + 1;
        }
    }
}
