//! From the text of an expression to its parts: precedence climbing, with a bound on how deep it goes. Behind a mistake
//! it goes on as if what was meant stood there, so that several mistakes are told at once.

use super::parser::{MAX_EXPRESSION_DEPTH, Parser, WORDS, Within};
use super::token::{self, Token};
use super::{Argument, Mistake, Operator, Part, PartKind, Span};

/// Longest expression, in characters.
pub const MAX_EXPRESSION: usize = 16_384;

/// How strongly what stands between two values binds; a choice binds least.
const CHOICE: u8 = 1;
const COMPARISON: u8 = 5;
/// Of `-` and `!` before a value: more than of a product, less than of a power.
const PREFIX: u8 = 8;
/// Of `not`, which comparisons are part of.
const NOT: u8 = 4;
const POWER: u8 = 9;

/// The operators that stand between two values, with how strongly they bind.
const BINARY: [(&str, Operator, u8); 16] = [
    ("||", Operator::Or, 2),
    ("or", Operator::Or, 2),
    ("&&", Operator::And, 3),
    ("and", Operator::And, 3),
    ("<", Operator::Less, COMPARISON),
    ("<=", Operator::LessEqual, COMPARISON),
    (">", Operator::Greater, COMPARISON),
    (">=", Operator::GreaterEqual, COMPARISON),
    ("==", Operator::Equal, COMPARISON),
    ("!=", Operator::NotEqual, COMPARISON),
    ("+", Operator::Add, 6),
    ("-", Operator::Subtract, 6),
    ("*", Operator::Multiply, 7),
    ("/", Operator::Divide, 7),
    ("%", Operator::Modulo, 7),
    ("**", Operator::Power, POWER),
];

/// The parts of an expression, the whole last.
///
/// # Errors
/// Its mistakes, in the order they were found.
pub(crate) fn parse(text: &str) -> Result<Vec<Part>, Vec<Mistake>> {
    if let Some((at, _)) = text.char_indices().nth(MAX_EXPRESSION) {
        let message = format!("an expression has at most {MAX_EXPRESSION} characters");
        let help = "put a part of it under `where`";
        return Err(vec![Mistake::new(at..text.len(), message, help)]);
    }
    let mut parser = Parser::new(text);
    parser.advance(0);
    if parser.token == Token::End && parser.mistakes.is_empty() {
        let help = "write a value, such as `0.5 * (noise + 1)`";
        return Err(vec![Mistake::new(0..text.len(), "the expression is empty", help)]);
    }
    parser.enclosed(Within::Text);
    if parser.mistakes.is_empty() { Ok(parser.parts) } else { Err(parser.mistakes) }
}

impl Parser<'_> {
    fn add(&mut self, span: Span, mark: Span, kind: PartKind) -> usize {
        self.parts.push(Part { span, mark, kind });
        self.parts.len() - 1
    }

    /// What stands for a value that is missing. Nothing is made of parts among which it is.
    pub fn missing(&mut self) -> usize {
        self.add(self.end..self.end, self.end..self.end, PartKind::Boolean(false))
    }

    /// A value, with operators that bind as strongly as `least` or more; its position.
    pub fn value(&mut self, least: u8) -> usize {
        self.depth += 1;
        let part = match self.depth > MAX_EXPRESSION_DEPTH {
            true => {
                self.too_deep();
                self.missing()
            }
            false => {
                let left = self.prefixed();
                self.continued(left, least)
            }
        };
        self.depth -= 1;
        part
    }

    /// A value with the operators behind it that bind as strongly as `least` or more.
    pub fn continued(&mut self, mut left: usize, least: u8) -> usize {
        loop {
            if least <= CHOICE && self.is("?") {
                left = self.choice(left);
                continue;
            }
            let Some((operator, binds)) = self.binary().filter(|(_, binds)| *binds >= least) else {
                return left;
            };
            left = self.operation(left, operator, binds);
        }
    }

    /// The operator that is next, if one is.
    pub fn binary(&self) -> Option<(Operator, u8)> {
        let sign = match &self.token {
            Token::Sign(sign) => sign,
            Token::Name(name) => name.as_str(),
            _ => return None,
        };
        BINARY
            .iter()
            .find(|(known, ..)| *known == sign)
            .map(|&(_, operator, binds)| (operator, binds))
    }

    fn operation(&mut self, left: usize, operator: Operator, binds: u8) -> usize {
        if operator.compares()
            && let Some((first, before)) = self.comparison(left)
        {
            let message =
                format!("`{}` and `{}` cannot be chained", before.sign(), operator.sign());
            let help = "join two comparisons: `a < b && b < c`";
            // Of a longer chain the first link is told.
            if self.comparison(first).is_none() {
                self.tell(Mistake::new(self.span.clone(), message, help));
            }
        }
        let mark = self.take();
        // A power binds from the right, and its exponent may have a sign.
        let right = self.value(if operator == Operator::Power { POWER } else { binds + 1 });
        let span = self.parts[left].span.start..self.end;
        self.add(span, mark, PartKind::Operation(operator, vec![left, right]))
    }

    /// The left side and the operator of a part that is a comparison and stands in no brackets.
    fn comparison(&self, part: usize) -> Option<(usize, Operator)> {
        let Part { span, kind: PartKind::Operation(operator, of), .. } = &self.parts[part] else {
            return None;
        };
        let bare = span.start == self.parts[of[0]].span.start;
        (operator.compares() && bare).then_some((of[0], *operator))
    }

    fn choice(&mut self, condition: usize) -> usize {
        let mark = self.take();
        let one = self.enclosed(Within::Choice);
        if !self.is(":") {
            self.expected("`:` and the other value", "write `condition ? one : other`");
            return self.missing();
        }
        self.take();
        let other = self.value(CHOICE);
        let span = self.parts[condition].span.start..self.end;
        self.add(span, mark, PartKind::Choice(condition, one, other))
    }

    /// A value with what stands before it.
    fn prefixed(&mut self) -> usize {
        let (operator, binds) = match &self.token {
            Token::Sign("-") => (Operator::Negate, PREFIX),
            Token::Sign("!") => (Operator::Not, PREFIX),
            Token::Name(name) if name == "not" => (Operator::Not, NOT),
            Token::Sign("+") => {
                let message = "a `+` before a value does nothing";
                let help = "remove it: a value without a sign is the same";
                self.tell(Mistake::new(self.span.clone(), message, help));
                self.take();
                return self.value(PREFIX);
            }
            _ => return self.followed(),
        };
        let mark = self.take();
        let operand = self.value(binds);
        let span = mark.start..self.end;
        if operator == Operator::Negate
            && operand + 1 == self.parts.len()
            && let Part { kind: PartKind::Number(number), .. } = &mut self.parts[operand]
            && !number.starts_with('-')
        {
            number.insert(0, '-');
            self.parts[operand].span = span;
            return operand;
        }
        self.add(span, mark, PartKind::Operation(operator, vec![operand]))
    }

    /// A value with the members and indices behind it.
    fn followed(&mut self) -> usize {
        let (mut part, start) = self.single();
        loop {
            if self.is(".") {
                self.take();
                let Token::Name(name) = self.token.clone() else {
                    let help = "such as `.x`, `.rgb` or the name of an output";
                    self.expected("a name behind `.`", help);
                    continue;
                };
                let mark = self.take();
                part = self.add(start..self.end, mark, PartKind::Member(part, name));
            } else if self.is("[") {
                part = self.element(part, start);
            } else {
                return part;
            }
        }
    }

    fn element(&mut self, of: usize, start: usize) -> usize {
        let open = self.take();
        let index = match &self.token {
            Token::Number(number) => number.parse::<usize>().ok(),
            _ => None,
        };
        let Some(index) = index else {
            let help =
                "an index is known before shading; an `element` node chooses by a computed one";
            self.expected("a whole number", help);
            self.skip_list();
            return of;
        };
        self.take();
        if !self.is("]") {
            self.expected("`]`", "an index is one whole number");
            self.skip_list();
            return of;
        }
        let close = self.take();
        self.add(start..self.end, open.start..close.end, PartKind::Element(of, index))
    }

    /// A value in itself, and where it starts, brackets included.
    fn single(&mut self) -> (usize, usize) {
        let start = self.span.start;
        let kind = match self.token.clone() {
            Token::Number(number) => PartKind::Number(number),
            Token::Text(text) => PartKind::Text(text),
            Token::Name(name) if name == "true" || name == "false" => {
                PartKind::Boolean(name == "true")
            }
            Token::Name(name) if !WORDS.contains(&name.as_str()) => {
                let mark = self.take();
                if self.is("(") {
                    return (self.call(name, mark), start);
                }
                return (self.add(mark.clone(), mark, PartKind::Name(name)), start);
            }
            Token::Sign("(") => {
                let open = self.take();
                let part = self.enclosed(Within::Brackets);
                self.close(open);
                self.parts[part].span = start..self.end;
                return (part, start);
            }
            Token::Sign("[") => {
                let message = "there are no lists in an expression";
                let help = "write `vector(x, y, z)` or `color(r, g, b)`";
                self.tell(Mistake::new(self.span.clone(), message, help));
                self.take();
                self.skip_list();
                return (self.missing(), start);
            }
            _ => {
                self.no_value();
                return (self.missing(), start);
            }
        };
        let mark = self.take();
        (self.add(mark.clone(), mark, kind), start)
    }

    fn call(&mut self, name: String, mark: Span) -> usize {
        let open = self.take();
        let mut arguments = Vec::new();
        while !self.is(")") {
            arguments.push(self.argument());
            if !self.is(",") {
                break;
            }
            let comma = self.take();
            if self.is(")") {
                let message = "an argument is missing behind this `,`";
                self.tell(Mistake::new(comma, message, "remove it"));
            }
        }
        self.close(open);
        self.add(mark.start..self.end, mark, PartKind::Call(name, arguments))
    }

    /// `value`, or `name: value`.
    fn argument(&mut self) -> Argument {
        let mut name = None;
        if let Token::Name(word) = self.token.clone()
            && !WORDS.contains(&word.as_str())
            && let Ok((Token::Sign(":"), _)) = token::next(self.text, self.span.end)
        {
            let span = self.take();
            self.take();
            name = Some((word, span));
        }
        Argument { name, value: self.enclosed(Within::Arguments) }
    }
}
