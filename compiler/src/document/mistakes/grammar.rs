//! The grammar of JSON over tokens, going on after what is wrong.

use crate::diagnostics::shortened;

use super::brackets::Corrections;
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;
use crate::document::MAX_DEPTH;

/// Most mistakes of structure: past them the text is hardly meant as JSON.
const MOST_OF_STRUCTURE: usize = 100;

/// What is due next within a bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Due {
    /// A key, or the end.
    Key,
    /// A colon.
    Colon,
    /// A value.
    Value,
    /// A comma, or the end.
    Comma,
}

struct Frame {
    open: u8,
    start: usize,
    due: Due,
    /// The comma before what is due.
    comma: Option<Token>,
    key: (usize, usize),
    /// A colon in a list.
    colon: Option<Token>,
    /// Position of the mistake that its bracket is, for round ones.
    told: Option<usize>,
    /// Whether values without keys were told of.
    keyless: bool,
}

impl Frame {
    fn new(open: u8, start: usize) -> Self {
        let due = if open == b'{' { Due::Key } else { Due::Value };
        let (comma, key, colon, told, keyless) = (None, (start, start), None, None, false);
        Self { open, start, due, comma, key, colon, told, keyless }
    }
}

/// What is wrong in a text beyond its brackets.
pub(super) fn mistakes(text: &str, corrections: &Corrections) -> Vec<Mistake> {
    let mut grammar = Grammar {
        lexer: Lexer::new(text, false),
        stack: Vec::new(),
        state: Root::Before,
        last: (0, Kind::Comma),
        structure: 0,
        missing: corrections.missing.iter().copied().peekable(),
        extra: corrections.extra.iter().copied().peekable(),
        balanced: !corrections.given_up,
    };
    while let Some(token) = grammar.lexer.next() {
        if !grammar.step(token) || grammar.structure >= MOST_OF_STRUCTURE {
            break;
        }
        grammar.last = (token.end, token.kind);
    }
    grammar.lexer.mistakes
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Root {
    Before,
    /// After a value that is no object and no list.
    Leaf(usize, usize),
    After,
}

struct Grammar<'t, M: Iterator, E: Iterator> {
    lexer: Lexer<'t>,
    stack: Vec<Frame>,
    state: Root,
    last: (usize, Kind),
    structure: usize,
    missing: std::iter::Peekable<M>,
    extra: std::iter::Peekable<E>,
    balanced: bool,
}

impl<M: Iterator<Item = (usize, usize)>, E: Iterator<Item = usize>> Grammar<'_, M, E> {
    /// Takes a token; whether to go on.
    fn step(&mut self, token: Token) -> bool {
        while let Some((_, count)) = self.missing.next_if(|(at, _)| *at <= token.start) {
            for _ in 0..count {
                self.end_unsaid();
            }
        }
        if self.extra.next_if(|at| *at == token.start).is_some() {
            return true;
        }
        let Some(top) = self.stack.last() else { return self.outside(token) };
        match (top.open, top.due) {
            (b'{', Due::Key) => self.key(token),
            (_, Due::Colon) => self.colon(token),
            (b'{', Due::Value) => self.value(token),
            (b'{', _) => self.after_value(token),
            (_, Due::Comma) => self.after_element(token),
            _ => self.element(token),
        }
        self.stack.len() <= MAX_DEPTH
    }

    fn tell(&mut self, mistake: Mistake) {
        self.structure += 1;
        self.lexer.tell(mistake);
    }

    fn tell_at(&mut self, place: (usize, usize), message: &str, help: &str) {
        self.tell(Mistake::new(place, message, help));
    }

    fn top(&mut self) -> &mut Frame {
        self.stack.last_mut().expect("a bracket is open")
    }

    fn text(&self, (start, end): (usize, usize)) -> &str {
        &self.lexer.text[start..end]
    }

    /// Ends a bracket whose closing one is missing; a comma before that belongs outside.
    fn end_unsaid(&mut self) {
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

    fn open(&mut self, open: u8, token: Token) {
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

    fn close(&mut self, token: Token) {
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

    fn lone_equals_or_colon(&mut self, frame: &Frame) {
        if let Some(colon) = frame.colon {
            let help = "a list holds values only; use `{ }` for keys";
            self.tell_at((colon.start, colon.end), "a `:` has no place here", help);
        }
    }

    /// A comma that is followed by something: whether it is one.
    fn settle_comma(&mut self) {
        if let Some(comma) = self.top().comma.take()
            && comma.kind == Kind::Semicolon
        {
            let place = (comma.start, comma.end);
            let mistake =
                Mistake::new(place, "elements are separated by `,`, not by `;`", "write `,`");
            self.tell(mistake.fixed_by(","));
        }
    }

    fn second_comma(&mut self, token: Token) {
        let place = (token.start, token.end);
        self.tell_at(place, "an element is missing before this comma", "remove the comma");
    }

    /// Before the value of the file, or after it.
    fn outside(&mut self, token: Token) -> bool {
        let place = (token.start, token.end);
        match (self.state, token.kind) {
            (Root::Before, Kind::Open(open)) => self.open(open, token),
            (Root::Before, Kind::String | Kind::Value) => {
                self.state = Root::Leaf(token.start, token.end);
            }
            (Root::Leaf(start, _), Kind::Colon | Kind::Equals) => {
                let message = "the file lacks the `{` it starts with";
                self.tell_at(
                    (start, start),
                    message,
                    "put `{` before it, and `}` at the end of the file",
                );
                return false;
            }
            (Root::Before, _) => {
                // A text of another kind has nothing in it that could be mended.
                self.lexer.mistakes.clear();
                let message = "this is no JSON: the file starts with something else than `{`";
                let help = "a graph or a scene is one JSON object: start with `{ \"phenomenon\": \"name\" … }`";
                self.tell_at(place, message, help);
                return false;
            }
            // Brackets that come out uneven were told of.
            (Root::After, Kind::Close(_)) if self.balanced => {}
            _ => {
                let help = "remove what follows; a file holds one object";
                self.tell_at(place, "the file goes on after its value", help);
                return false;
            }
        }
        true
    }

    fn key(&mut self, token: Token) {
        let place = (token.start, token.end);
        let leads_on =
            matches!(self.lexer.peek().map(|it| it.kind), Some(Kind::Colon | Kind::Equals));
        match token.kind {
            Kind::String => {
                self.settle_comma();
                (self.top().key, self.top().due, self.top().keyless) = (place, Due::Colon, false);
            }
            Kind::Close(_) => self.close(token),
            Kind::Comma | Kind::Semicolon => {
                if !self.top().keyless {
                    self.second_comma(token);
                }
            }
            Kind::Word | Kind::Value if leads_on => {
                self.settle_comma();
                let word = self.text(place).to_owned();
                let shown = shortened(&word);
                let message = "a key must be a string in double quotes";
                let mistake = Mistake::new(place, message, format!("write `\"{shown}\"`"));
                let plain =
                    word.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '$'));
                let fix = plain.then(|| format!("\"{word}\""));
                self.tell(Mistake { fix, ..mistake });
                (self.top().key, self.top().due) = (place, Due::Colon);
            }
            Kind::Word | Kind::Value => {
                self.settle_comma();
                if !std::mem::replace(&mut self.top().keyless, true) {
                    let message = "a key in double quotes must stand here";
                    let help =
                        "write `\"key\": value`; a list of values stands between `[` and `]`";
                    self.tell_at(place, message, help);
                }
            }
            Kind::Colon | Kind::Equals => {
                self.settle_comma();
                self.tell_at(place, "a key is missing before this", "write `\"key\": value`");
                self.top().due = Due::Value;
            }
            Kind::Open(open) => {
                self.settle_comma();
                if !std::mem::replace(&mut self.top().keyless, true) {
                    self.tell_at(place, "a key is missing before this", "write `\"key\": value`");
                }
                self.open(open, token);
            }
        }
    }

    fn colon(&mut self, token: Token) {
        let key = self.top().key;
        let place = (token.start, token.end);
        match token.kind {
            Kind::Colon => self.top().due = Due::Value,
            Kind::Equals => {
                let mistake =
                    Mistake::new(place, "a key and its value are joined by `:`", "write `:`");
                self.tell(mistake.fixed_by(":"));
                self.top().due = Due::Value;
            }
            Kind::Comma | Kind::Semicolon | Kind::Close(_) => {
                self.tell_at(key, "this key has no value", "write `\"key\": value`");
                self.top().due = Due::Comma;
                self.after_value(token);
            }
            Kind::String if matches!(self.lexer.peek().map(|it| it.kind), Some(Kind::Colon)) => {
                self.tell_at(key, "this key has no value", "write `\"key\": value,`");
                (self.top().key, self.top().due) = (place, Due::Colon);
            }
            _ => {
                let message = "a `:` is missing after this key";
                let mistake = Mistake::new(key, message, "write `\"key\": value`");
                let fixed = format!("{}:", self.text(key));
                self.tell(if fixed.starts_with('"') { mistake.fixed_by(fixed) } else { mistake });
                self.value(token);
            }
        }
    }

    fn value(&mut self, token: Token) {
        let place = (token.start, token.end);
        match token.kind {
            Kind::String | Kind::Value => self.top().due = Due::Comma,
            Kind::Word => self.word_as_value(token),
            Kind::Open(open) => self.open(open, token),
            Kind::Comma | Kind::Semicolon | Kind::Close(_) => {
                let key = self.top().key;
                self.tell_at(key, "this key has no value", "write `\"key\": value`");
                self.top().due = Due::Comma;
                self.after_value(token);
            }
            Kind::Colon | Kind::Equals => {
                let mistake = Mistake::new(place, "there is one `:` already", "remove this");
                self.tell(mistake.fixed_by(""));
            }
        }
    }

    fn word_as_value(&mut self, token: Token) {
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

    fn after_value(&mut self, token: Token) {
        let place = (token.start, token.end);
        let leads_on =
            matches!(self.lexer.peek().map(|it| it.kind), Some(Kind::Colon | Kind::Equals));
        match token.kind {
            Kind::Comma | Kind::Semicolon => {
                (self.top().comma, self.top().due) = (Some(token), Due::Key);
            }
            Kind::Close(_) => self.close(token),
            Kind::String | Kind::Word if leads_on => {
                self.missing_comma();
                self.top().due = Due::Key;
                self.key(token);
            }
            Kind::Colon | Kind::Equals => {
                let message = "a `:` has no place here: the value has ended";
                self.tell_at(place, message, "write `\"key\": value`, and `,` before the next key");
                self.top().due = Due::Value;
            }
            // Several words are one mistake.
            Kind::String | Kind::Word | Kind::Value => {
                if self.last.1 != Kind::Word {
                    let message = "this follows a value that has ended";
                    self.tell_at(
                        place,
                        message,
                        "write `,` and `\"key\": value`, or `[ ]` round a list",
                    );
                }
            }
            Kind::Open(open) => {
                self.tell_at(place, "a key is missing before this", "write `, \"key\": value`");
                self.open(open, token);
            }
        }
    }

    fn element(&mut self, token: Token) {
        match token.kind {
            Kind::Close(_) => self.close(token),
            Kind::Comma | Kind::Semicolon => self.second_comma(token),
            Kind::String | Kind::Value => {
                self.settle_comma();
                self.top().due = Due::Comma;
            }
            Kind::Word => {
                self.settle_comma();
                self.word_as_value(token);
            }
            Kind::Open(open) => {
                self.settle_comma();
                self.open(open, token);
            }
            Kind::Colon | Kind::Equals => {
                self.settle_comma();
                self.top().colon.get_or_insert(token);
            }
        }
    }

    fn after_element(&mut self, token: Token) {
        match token.kind {
            Kind::Comma | Kind::Semicolon => {
                (self.top().comma, self.top().due) = (Some(token), Due::Value);
            }
            Kind::Close(_) => self.close(token),
            Kind::Colon | Kind::Equals => {
                self.top().colon.get_or_insert(token);
                self.top().due = Due::Value;
            }
            Kind::Word if self.last.1 == Kind::Word => {}
            _ => {
                self.missing_comma();
                self.top().due = Due::Value;
                self.element(token);
            }
        }
    }

    /// A comma that is missing after the last token.
    fn missing_comma(&mut self) {
        let at = self.last.0;
        let mistake =
            Mistake::new((at, at), "a comma is missing here", "separate elements with `,`");
        self.tell(mistake.fixed_by(","));
    }
}
