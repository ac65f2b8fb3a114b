//! Tokens of JSON and of what is taken for it.

use super::characters::{Class, class_of, is_of_a_word, line_end, opens};
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;

impl Lexer<'_> {
    /// The next token, which stays.
    pub fn peek(&mut self) -> Option<Token> {
        if self.peeked.is_none() {
            self.peeked = self.read();
        }
        self.peeked
    }

    /// The next token.
    pub fn next(&mut self) -> Option<Token> {
        self.peeked.take().or_else(|| self.read())
    }

    fn read(&mut self) -> Option<Token> {
        loop {
            if self.is_full() {
                return None;
            }
            let start = self.at;
            let c = self.character(start)?;
            self.at += c.len_utf8();
            let kind = match c {
                '\n' => {
                    (self.line, self.line_start, self.fresh) = (self.line + 1, self.at, true);
                    continue;
                }
                ' ' | '\t' | '\r' => continue,
                '"' => return Some(self.string(start)),
                '{' | '[' | '(' => Kind::Open(c as u8),
                '}' | ']' | ')' => Kind::Close(c as u8),
                ',' => Kind::Comma,
                ';' => Kind::Semicolon,
                ':' => Kind::Colon,
                '=' => {
                    while matches!(self.byte(self.at), Some(b'=' | b'>')) {
                        self.at += 1;
                    }
                    Kind::Equals
                }
                '#' => {
                    self.comment(start, "\n");
                    continue;
                }
                '/' if self.byte(self.at) == Some(b'/') => {
                    self.comment(start, "\n");
                    continue;
                }
                '/' if self.byte(self.at) == Some(b'*') => {
                    self.comment(start, "*/");
                    continue;
                }
                c if opens(c) => return Some(self.quoted(start, c)),
                c if is_of_a_word(c) => return Some(self.word(start)),
                c => match self.wide(start, c).or_else(|| self.stray(start, c)) {
                    Some(kind) => kind,
                    None => continue,
                },
            };
            return Some(self.token(kind, start));
        }
    }

    fn comment(&mut self, start: usize, end: &str) {
        let found = self.text[self.at..].find(end);
        let past = if end == "\n" { 0 } else { end.len() };
        self.at = found.map_or(self.text.len(), |at| self.at + at + past);
        // `/*/` is no whole comment.
        if end == "*/" && self.at < start + 4 {
            self.at = self.text[start + 2..]
                .get(1..)
                .and_then(|rest| rest.find(end))
                .map_or(self.text.len(), |at| start + 3 + at + past);
        }
        let continues = self.comment.is_some_and(|before| {
            self.text[before..start].bytes().all(|b| b.is_ascii_whitespace())
        });
        self.comment = Some(self.at);
        self.count_lines(start);
        if !continues {
            let place = (start, self.at.min(line_end(self.text, start)));
            let help = "move the text into a `\"doc\"` of the node or parameter";
            self.tell(Mistake::new(place, "JSON has no comments", help));
        }
    }

    /// Punctuation of other scripts, which stands for ours.
    fn wide(&mut self, start: usize, c: char) -> Option<Kind> {
        let (kind, plain) = match c {
            '，' | '、' => (Kind::Comma, ","),
            '：' => (Kind::Colon, ":"),
            '｛' => (Kind::Open(b'{'), "{"),
            '｝' => (Kind::Close(b'}'), "}"),
            '［' => (Kind::Open(b'['), "["),
            '］' => (Kind::Close(b']'), "]"),
            _ => return None,
        };
        let message = format!("`{c}` is no JSON punctuation");
        let mistake = Mistake::new((start, self.at), message, format!("write `{plain}`"));
        self.tell(mistake.fixed_by(plain));
        Some(kind)
    }

    /// Characters that start nothing; a run of them is one mistake.
    fn stray(&mut self, start: usize, c: char) -> Option<Kind> {
        let class = class_of(c);
        while let Some(next) = self.character(self.at).filter(|&next| class_of(next) == class) {
            let stands_for_something = next == '"'
                || opens(next)
                || is_of_a_word(next)
                || matches!(
                    next,
                    '{' | '}' | '[' | ']' | '(' | ')' | ',' | ';' | ':' | '=' | '#' | '/'
                )
                || (class == Class::Other && next.is_ascii_whitespace());
            if stands_for_something {
                break;
            }
            self.at += next.len_utf8();
        }
        let place = (start, self.at);
        let named = format!("U+{:04X}", u32::from(c));
        let mistake = match class {
            Class::Space => Mistake::new(
                place,
                format!("the white space {named} is none in JSON"),
                "write a space",
            )
            .fixed_by(" "),
            Class::Nothing if c == '\u{feff}' && start == 0 => Mistake::new(
                place,
                "the file has a byte order mark, which JSON does not allow",
                "save the file as UTF-8 without BOM",
            )
            .fixed_by(""),
            Class::Nothing => Mistake::new(
                place,
                format!("the character {named}, which cannot be seen, stands outside of strings"),
                "remove it",
            )
            .fixed_by(""),
            Class::Other => Mistake::new(
                place,
                format!("unexpected character {c:?}"),
                "outside strings JSON has only ASCII punctuation, numbers, true, false and null",
            ),
        };
        self.tell(mistake);
        None
    }
}
