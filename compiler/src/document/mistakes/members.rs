//! What stands within an object: keys and values.

use crate::diagnostics::shortened;

use super::lexer::{Kind, Token};
use super::mistake::Mistake;
use super::standing::{Due, Grammar};

impl Grammar<'_> {
    pub fn key(&mut self, token: Token) {
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

    pub fn colon(&mut self, token: Token) {
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

    pub fn value(&mut self, token: Token) {
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

    pub fn after_value(&mut self, token: Token) {
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
}
