//! What stands within a list.

use super::lexer::{Kind, Token};
use super::standing::{Due, Grammar};

impl Grammar<'_> {
    pub fn element(&mut self, token: Token) {
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

    pub fn after_element(&mut self, token: Token) {
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
}
