//! Matching brackets of which some are missing or too many.

use crate::diagnostics::shortened;

use super::corrections::Corrections;
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;

/// Keys that stand only at the top of a file, for files that are not indented.
const TOP_KEYS: [&str; 9] = [
    "requires",
    "interface",
    "nodes",
    "roots",
    "camera",
    "objects",
    "lights",
    "environment",
    "options",
];

/// A bracket that is open.
#[derive(Clone, Debug)]
struct Frame {
    open: u8,
    start: usize,
    line: usize,
    /// Indentation of the line it stands on.
    indent: usize,
    /// Indentation of the first line that starts within it.
    child: Option<usize>,
    /// The key it is the value of.
    key: Option<(usize, usize)>,
}

/// Brackets as they are matched.
pub(super) struct Matching<'t> {
    text: &'t str,
    /// Where the text starts, after white space.
    start: usize,
    /// How many closing brackets are missing, or too many, and not found yet.
    pub missing: usize,
    extra: usize,
    stack: Vec<Frame>,
    /// Closed since the last line started, each with the byte of its closing bracket.
    closed: Vec<(Frame, usize)>,
    /// The bracket that closed the outermost one, and that one.
    end: Option<(Frame, usize)>,
    /// End of the last token that is no comma, its kind, and its line.
    last: (usize, Kind, usize),
    line_indent: usize,
    /// Whether something follows the end of what the file holds.
    pub overrun: bool,
    found: Corrections,
}

impl<'t> Matching<'t> {
    /// Matches the brackets of a text of which so many are missing, and so many too many.
    pub fn of(text: &'t str, missing: usize, extra: usize, by_keys: bool) -> Self {
        let mut matching = Self {
            text,
            start: text.len() - text.trim_start().len(),
            missing,
            extra,
            stack: Vec::new(),
            closed: Vec::new(),
            end: None,
            last: (0, Kind::Comma, 1),
            line_indent: 0,
            overrun: false,
            found: Corrections::default(),
        };
        let mut lexer = Lexer::new(text, true);
        let mut key: Option<(usize, usize)> = None;
        let mut before = Kind::Comma;
        while let Some(token) = lexer.next() {
            if let Some(indent) = token.indent {
                matching.line_indent = indent;
                // Within a value that goes on, lines stand as they like.
                if !matches!(before, Kind::Colon | Kind::Equals) {
                    matching.start_line(token, indent);
                }
                matching.closed.clear();
            }
            match token.kind {
                Kind::String | Kind::Word => {
                    let is_key =
                        matches!(lexer.peek().map(|it| it.kind), Some(Kind::Colon | Kind::Equals));
                    key = is_key.then_some((token.start, token.end));
                    if is_key && by_keys {
                        matching.top_key(token);
                    }
                    matching.go_on();
                }
                Kind::Open(open) => {
                    matching.go_on();
                    let key = key.take().filter(|_| matches!(before, Kind::Colon | Kind::Equals));
                    matching.open(open, token, key);
                }
                Kind::Close(close) => matching.close(close, token),
                _ => {}
            }
            before = token.kind;
            if !matches!(token.kind, Kind::Comma | Kind::Semicolon) {
                matching.last = (token.end, token.kind, token.line);
            }
        }
        matching
    }

    /// Whether all brackets are accounted for.
    pub fn is_solved(&self) -> bool {
        self.missing == 0 && self.extra == 0 && self.stack.is_empty() && !self.overrun
    }

    fn open(&mut self, open: u8, token: Token, key: Option<(usize, usize)>) {
        let (start, line, indent) = (token.start, token.line, self.line_indent);
        self.stack.push(Frame { open, start, line, indent, child: None, key });
    }

    /// What a line says of the brackets before it.
    fn start_line(&mut self, token: Token, indent: usize) {
        let is_close = matches!(token.kind, Kind::Close(_));
        let suits = |frame: &Frame| match token.kind {
            Kind::Close(close) => matches(frame.open, close) && frame.indent == indent,
            _ => frame.child == Some(indent) && indent > frame.indent,
        };
        let top = self.stack.last().filter(|top| top.line < token.line);
        if top.is_some_and(|top| suits(top) || (!is_close && top.child == Some(indent))) {
            return;
        }
        let opens_out = top.is_some_and(|top| {
            if is_close {
                top.indent > indent
            } else {
                top.indent >= indent || top.child.is_some_and(|child| child > indent)
            }
        });
        if self.missing > 0 && opens_out {
            let outer =
                self.stack.iter().rposition(|frame| frame.line < token.line && suits(frame));
            let above = outer.map_or(0, |at| self.stack.len() - 1 - at);
            if (1..=self.missing).contains(&above) {
                self.add_missing(token, above);
                return self.child(indent, is_close, token.line);
            }
        }
        if self.extra > 0
            && let Some(at) = self.closed.iter().rposition(|(frame, _)| suits(frame))
        {
            let undone = self.closed.len() - at;
            if undone <= self.extra {
                self.undo(undone);
                return;
            }
        }
        self.child(indent, is_close, token.line);
    }

    /// Keeps how far the first line within the innermost bracket stands in.
    fn child(&mut self, indent: usize, is_close: bool, line: usize) {
        if let Some(top) = self.stack.last_mut().filter(|top| !is_close && top.line < line) {
            top.child.get_or_insert(indent);
        }
    }

    /// A key of the top of a file that stands deeper: what is open between was to be closed before.
    fn top_key(&mut self, token: Token) {
        let name = self.text[token.start..token.end].trim_matches('"');
        let above = self.stack.len().saturating_sub(1);
        let in_objects = self.stack.iter().all(|frame| frame.open == b'{');
        let known = self.stack.iter().skip(1).any(|frame| {
            frame.key.is_some_and(|(start, end)| {
                TOP_KEYS.contains(&self.text[start..end].trim_matches('"'))
            })
        });
        if TOP_KEYS.contains(&name) && in_objects && known && (1..=self.missing).contains(&above) {
            self.add_missing(token, above);
        }
    }

    /// So many brackets, the innermost, were to be closed before a token.
    fn add_missing(&mut self, token: Token, count: usize) {
        let (at, _, last_line) = self.last;
        self.missing -= count;
        self.found.missing.push((token.start, count));
        let frames = self.stack.split_off(self.stack.len() - count);
        let closers: String = frames.iter().rev().map(|frame| closer(frame.open)).collect();
        let outermost = &frames[0];
        let what = self.name(outermost);
        let message = format!("`{closers}` is missing here: {what} is never closed");
        let help = if token.line > last_line {
            let line = token.line;
            format!("add `{closers}` at the end of line {last_line}: line {line} stands outside")
        } else {
            format!("add `{closers}`")
        };
        let mistake = Mistake::new((at, at), message, help);
        let start = outermost.start;
        self.found.tell(mistake.with((start, start + 1), "opened here"));
    }

    /// The last brackets that were closed stay open: those that closed them are too many.
    fn undo(&mut self, count: usize) {
        self.extra -= count;
        let undone = self.closed.split_off(self.closed.len() - count);
        for (frame, close) in undone.into_iter().rev() {
            self.too_many(&frame, close);
            if self.stack.is_empty() {
                self.end = None;
            }
            self.stack.push(frame);
        }
    }

    fn too_many(&mut self, frame: &Frame, close: usize) {
        self.found.extra.push(close);
        let bracket = char::from(self.text.as_bytes()[close]);
        let what = self.name(frame);
        let message = format!("one `{bracket}` too many: this one closes {what}");
        let mistake = Mistake::new((close, close + 1), message, format!("remove one `{bracket}`"));
        let opened = (frame.start, frame.start + 1);
        self.found.tell(mistake.with(opened, "what it closes was opened here"));
    }

    /// Something stands where the outermost bracket is closed: if brackets are too many, that is one.
    fn go_on(&mut self) {
        let Some((frame, close)) = self.end.take_if(|_| self.stack.is_empty()) else { return };
        if self.extra > 0 {
            self.extra -= 1;
            self.too_many(&frame, close);
            self.stack.push(frame);
        } else {
            self.overrun = true;
        }
    }

    fn close(&mut self, close: u8, token: Token) {
        // Further out than brackets are missing nothing can be closed.
        let reach = self.stack.iter().rev().take(self.missing + 1);
        let above = reach.map(|frame| frame.open).position(|open| matches(open, close));
        let above = above.unwrap_or(0);
        match self.stack.last() {
            Some(top) if matches(top.open, close) => self.pop(token),
            // Nothing is open any more.
            None => {
                if self.extra > 0 {
                    self.extra -= 1;
                    self.found.extra.push(token.start);
                    let bracket = char::from(close);
                    let message = format!("one `{bracket}` too many: nothing is open here");
                    let mut mistake = Mistake::new(
                        (token.start, token.end),
                        message,
                        format!("remove one `{bracket}`"),
                    );
                    if let Some((frame, end)) = &self.end {
                        mistake = mistake
                            .with(
                                (frame.start, frame.start + 1),
                                "what the file holds was opened here",
                            )
                            .with((*end, end + 1), "and closed here");
                    }
                    self.found.tell(mistake);
                }
            }
            Some(_) if (1..=self.missing).contains(&above) => {
                self.add_missing(token, above);
                self.pop(token);
            }
            Some(top) if self.extra > 0 => {
                let (bracket, open) = (char::from(close), (top.start, top.start + 1));
                let what = self.name(top);
                let message = format!("this `{bracket}` closes nothing: {what} is open here");
                let help = format!("remove it, or open with `{}` what it closes", opener(close));
                let mistake = Mistake::new((token.start, token.end), message, help);
                self.extra -= 1;
                self.found.extra.push(token.start);
                self.found.tell(mistake.with(open, "opened here"));
            }
            Some(top) => {
                let (bracket, right) = (char::from(close), closer(top.open));
                let what = self.name(top);
                let message = format!(
                    "this `{bracket}` closes {what}, which opens with `{}`",
                    char::from(top.open)
                );
                let open = (top.start, top.start + 1);
                let mistake =
                    Mistake::new((token.start, token.end), message, format!("write `{right}`"));
                self.found.tell(mistake.with(open, "opened here").fixed_by(right));
                self.pop(token);
            }
        }
    }

    fn pop(&mut self, token: Token) {
        let Some(frame) = self.stack.pop() else { return };
        if self.stack.is_empty() {
            self.end = Some((frame.clone(), token.start));
        }
        self.closed.push((frame, token.start));
    }

    /// What a bracket opened, for messages.
    fn name(&self, frame: &Frame) -> String {
        let kind = if frame.open == b'{' { "object" } else { "list" };
        match frame.key {
            Some((start, end)) => {
                let key = self.text[start..end].trim_matches('"');
                format!("`{}`", shortened(key))
            }
            None if frame.start <= self.start => {
                format!("the {kind} the file starts with")
            }
            None => format!("this {kind}"),
        }
    }

    /// Tells of what is still open at the end.
    pub fn finish(mut self) -> Corrections {
        if let (Some(innermost), true) = (self.stack.last(), self.missing > 0) {
            let closers: String =
                self.stack.iter().rev().take(8).map(|frame| closer(frame.open)).collect();
            let open = (innermost.start, innermost.start + 1);
            let (end, last, _) = self.last;
            let mistake = if self.stack.len() == 1 && matches!(last, Kind::Close(_)) {
                let what = self.name(innermost);
                let bracket = char::from(innermost.open);
                let message = format!(
                    "this `{bracket}` is never closed: {what} goes on to the end of the file"
                );
                let help = format!("add the missing `{closers}`, at the end or where it belongs");
                Mistake::new(open, message, help)
            } else {
                let what = self.name(innermost);
                let message = format!("the file ends, and {what} is never closed");
                let help = format!("add the missing `{closers}`");
                let mut mistake = Mistake::new((end, end), message, help);
                for frame in self.stack.iter().rev().take(3) {
                    mistake = mistake.with((frame.start, frame.start + 1), "opened here");
                }
                mistake
            };
            self.found.tell(mistake);
        }
        self.found.extra.sort_unstable();
        self.found.missing.sort_unstable();
        self.found
    }
}

/// Whether a bracket closes another; round ones are told of as what they are.
fn matches(open: u8, close: u8) -> bool {
    (open == b'{') == (close == b'}')
}

fn closer(open: u8) -> char {
    if open == b'{' { '}' } else { ']' }
}

fn opener(close: u8) -> char {
    if close == b'}' { '{' } else { '[' }
}
