//! The grammar of JSON over tokens, going on after what is wrong.

use crate::document::MAX_DEPTH;

use super::corrections::Corrections;
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;
use super::standing::{Due, Grammar, Root};

/// Most mistakes of structure: past them the text is hardly meant as JSON.
const MOST_OF_STRUCTURE: usize = 100;

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

impl Grammar<'_> {
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
}
