//! Where a reading of the grammar stands, and what it does wherever it stands.

use std::iter::{Copied, Peekable};
use std::slice::Iter;

use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;

/// What is due next within a bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Due {
    /// A key, or the end.
    Key,
    /// A colon.
    Colon,
    /// A value.
    Value,
    /// A comma, or the end.
    Comma,
}

/// A bracket that is open.
pub(super) struct Frame {
    pub open: u8,
    pub start: usize,
    pub due: Due,
    /// The comma before what is due.
    pub comma: Option<Token>,
    pub key: (usize, usize),
    /// A colon in a list.
    pub colon: Option<Token>,
    /// Position of the mistake that its bracket is, for round ones.
    pub told: Option<usize>,
    /// Whether values without keys were told of.
    pub keyless: bool,
}

impl Frame {
    pub fn new(open: u8, start: usize) -> Self {
        let due = if open == b'{' { Due::Key } else { Due::Value };
        let (comma, key, colon, told, keyless) = (None, (start, start), None, None, false);
        Self { open, start, due, comma, key, colon, told, keyless }
    }
}

/// Where reading stands outside of all brackets.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Root {
    /// Before the value of the file.
    Before,
    /// After a value that is no object and no list.
    Leaf(usize, usize),
    /// After its value.
    After,
}

/// A reading of the grammar.
pub(super) struct Grammar<'t> {
    pub lexer: Lexer<'t>,
    pub stack: Vec<Frame>,
    pub state: Root,
    pub last: (usize, Kind),
    pub structure: usize,
    pub missing: Peekable<Copied<Iter<'t, (usize, usize)>>>,
    pub extra: Peekable<Copied<Iter<'t, usize>>>,
    pub balanced: bool,
}

impl Grammar<'_> {
    pub fn tell(&mut self, mistake: Mistake) {
        self.structure += 1;
        self.lexer.tell(mistake);
    }

    pub fn tell_at(&mut self, place: (usize, usize), message: &str, help: &str) {
        self.tell(Mistake::new(place, message, help));
    }

    pub fn top(&mut self) -> &mut Frame {
        self.stack.last_mut().expect("a bracket is open")
    }

    pub fn text(&self, (start, end): (usize, usize)) -> &str {
        &self.lexer.text[start..end]
    }

    /// Ends a bracket whose closing one is missing; a comma before that belongs outside.
    pub fn end_unsaid(&mut self) {
        let Some(ended) = self.stack.pop() else { return };
        if let Some(outer) = self.stack.last_mut() {
            outer.due = Due::Comma;
            if let Some(comma) = ended.comma {
                outer.comma = Some(comma);
                outer.due = if outer.open == b'{' { Due::Key } else { Due::Value };
            }
        } else {
            self.state = Root::After;
        }
    }

    pub fn open(&mut self, open: u8, token: Token) {
        let mut frame = Frame::new(open, token.start);
        if open == b'(' {
            frame.told = Some(self.lexer.mistakes.len());
            let message = "a list stands between square brackets";
            self.tell_at((token.start, token.end), message, "write `[` and `]`");
        }
        if let Some(outer) = self.stack.last_mut() {
            outer.due = Due::Comma;
            outer.comma = None;
        }
        self.stack.push(frame);
    }

    pub fn close(&mut self, token: Token) {
        let Some(frame) = self.stack.pop() else { return };
        match frame.comma {
            Some(comma) => {
                let place = (comma.start, comma.end);
                let mistake =
                    Mistake::new(place, "a comma after the last element", "remove the comma");
                self.tell(mistake.fixed_by(""));
            }
            None => self.lone_equals_or_colon(&frame),
        }
        // A list in round brackets that is right but for them can be put into others.
        if let Some(told) = frame.told.filter(|told| *told + 1 == self.lexer.mistakes.len()) {
            let inner = self.text((frame.start + 1, token.start)).to_owned();
            let mistake = &mut self.lexer.mistakes[told];
            mistake.end = token.end;
            if self.lexer.text.as_bytes()[token.start] == b')' {
                mistake.fix = Some(format!("[{inner}]"));
            }
        }
        match self.stack.last_mut() {
            Some(outer) => outer.due = Due::Comma,
            None => self.state = Root::After,
        }
    }

    pub fn lone_equals_or_colon(&mut self, frame: &Frame) {
        if let Some(colon) = frame.colon {
            let help = "a list holds values only; use `{ }` for keys";
            self.tell_at((colon.start, colon.end), "a `:` has no place here", help);
        }
    }

    /// A comma that is followed by something: whether it is one.
    pub fn settle_comma(&mut self) {
        if let Some(comma) = self.top().comma.take()
            && comma.kind == Kind::Semicolon
        {
            let place = (comma.start, comma.end);
            let mistake =
                Mistake::new(place, "elements are separated by `,`, not by `;`", "write `,`");
            self.tell(mistake.fixed_by(","));
        }
    }

    pub fn second_comma(&mut self, token: Token) {
        let place = (token.start, token.end);
        self.tell_at(place, "an element is missing before this comma", "remove the comma");
    }

    pub fn word_as_value(&mut self, token: Token) {
        let mistake = self.lexer.no_value(&token);
        self.tell(mistake);
        self.top().due = Due::Comma;
        // A call has its arguments as a list, which is told of with it.
        if self.lexer.is_call(&token)
            && let Some(Token { kind: Kind::Open(open), start, .. }) = self.lexer.peek()
        {
            self.lexer.next();
            self.stack.push(Frame::new(open, start));
        }
    }

    /// A comma that is missing after the last token.
    pub fn missing_comma(&mut self) {
        let at = self.last.0;
        let mistake =
            Mistake::new((at, at), "a comma is missing here", "separate elements with `,`");
        self.tell(mistake.fixed_by(","));
    }
}
