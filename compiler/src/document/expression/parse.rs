//! From the text of an expression to its parts: precedence climbing, with a bound on how deep it goes.

use super::token::{self, Token};
use super::{Argument, Mistake, Operator, Part, PartKind, Span};

/// Longest expression, in characters.
pub const MAX_EXPRESSION: usize = 16_384;

/// How deep brackets, signs before a value and choices may be nested.
pub const MAX_EXPRESSION_DEPTH: usize = 64;

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

/// Words that are no names.
const WORDS: [&str; 5] = ["and", "or", "not", "true", "false"];

/// The parts of an expression, the whole last.
///
/// # Errors
/// Its first mistake.
pub(crate) fn parse(text: &str) -> Result<Vec<Part>, Mistake> {
    if let Some((at, _)) = text.char_indices().nth(MAX_EXPRESSION) {
        let message = format!("an expression has at most {MAX_EXPRESSION} characters");
        return Err(Mistake::new(at..text.len(), message, "put a part of it under `where`"));
    }
    let (token, span) = token::next(text, 0)?;
    let mut parser = Parser { text, token, span, end: 0, depth: 0, parts: Vec::new() };
    if parser.token == Token::End {
        let help = "write a value, such as `0.5 * (noise + 1)`";
        return Err(Mistake::new(0..text.len(), "the expression is empty", help));
    }
    parser.value(0)?;
    match &parser.token {
        Token::End => Ok(parser.parts),
        _ => Err(parser.surplus()),
    }
}

struct Parser<'t> {
    text: &'t str,
    /// The next token, and its place.
    token: Token,
    span: Span,
    /// Past the last token that was taken.
    end: usize,
    depth: usize,
    parts: Vec<Part>,
}

impl Parser<'_> {
    /// Takes the next token; gives its place.
    fn take(&mut self) -> Result<Span, Mistake> {
        let span = self.span.clone();
        self.end = span.end;
        (self.token, self.span) = token::next(self.text, span.end)?;
        Ok(span)
    }

    fn is(&self, sign: &str) -> bool {
        matches!(&self.token, Token::Sign(found) if *found == sign)
    }

    fn add(&mut self, span: Span, mark: Span, kind: PartKind) -> usize {
        self.parts.push(Part { span, mark, kind });
        self.parts.len() - 1
    }

    /// A mistake at the next token: what was expected in its place.
    fn expected<T>(&self, what: &str, help: impl Into<String>) -> Result<T, Mistake> {
        let message = format!("expected {what}, found {}", self.token.describe());
        // At the end there is nothing to point at but what stands before it.
        let span = match self.token {
            Token::End => {
                let last = self.text[..self.end].chars().next_back().map_or(0, char::len_utf8);
                self.end - last..self.end
            }
            _ => self.span.clone(),
        };
        Err(Mistake::new(span, message, help))
    }

    /// What is said of a token behind a whole value.
    fn surplus(&self) -> Mistake {
        let (span, found) = (self.span.clone(), self.token.describe());
        match &self.token {
            Token::Sign(")") => {
                Mistake::new(span, "this `)` closes nothing", "remove it, or add a `(`")
            }
            Token::Sign("]") => {
                Mistake::new(span, "this `]` closes nothing", "remove it, or add a `[`")
            }
            Token::Sign(":") => {
                Mistake::new(span, "this `:` has no `?`", "write `condition ? one : other`")
            }
            Token::Sign(",") => {
                let help = "write `vector(x, y, z)` or `color(r, g, b)` for several numbers";
                Mistake::new(span, "an expression is one value", help)
            }
            _ => {
                let message = format!("expected an operator, found {found}");
                Mistake::new(span, message, "put an operator such as `*` between the two values")
            }
        }
    }

    /// A value, with operators that bind as strongly as `least` or more; its position.
    fn value(&mut self, least: u8) -> Result<usize, Mistake> {
        self.depth += 1;
        if self.depth > MAX_EXPRESSION_DEPTH {
            let message = format!("the expression is nested more than {MAX_EXPRESSION_DEPTH} deep");
            let help = "put a part of it under `where`";
            return Err(Mistake::new(self.span.clone(), message, help));
        }
        let mut left = self.prefixed()?;
        loop {
            if least <= CHOICE && self.is("?") {
                left = self.choice(left)?;
                continue;
            }
            let Some((operator, binds)) = self.binary().filter(|(_, binds)| *binds >= least) else {
                break;
            };
            left = self.operation(left, operator, binds)?;
        }
        self.depth -= 1;
        Ok(left)
    }

    /// The operator that is next, if one is.
    fn binary(&self) -> Option<(Operator, u8)> {
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

    fn operation(&mut self, left: usize, operator: Operator, binds: u8) -> Result<usize, Mistake> {
        let mark = self.take()?;
        // A power binds from the right, and its exponent may have a sign.
        let right = self.value(if operator == Operator::Power { POWER } else { binds + 1 })?;
        if operator.compares()
            && let Some((next, COMPARISON)) = self.binary()
        {
            let message = format!("`{}` and `{}` cannot be chained", operator.sign(), next.sign());
            let help = "join two comparisons: `a < b && b < c`";
            return Err(Mistake::new(self.span.clone(), message, help));
        }
        let span = self.parts[left].span.start..self.end;
        Ok(self.add(span, mark, PartKind::Operation(operator, vec![left, right])))
    }

    fn choice(&mut self, condition: usize) -> Result<usize, Mistake> {
        let mark = self.take()?;
        let one = self.value(0)?;
        if !self.is(":") {
            return self.expected("`:` and the other value", "write `condition ? one : other`");
        }
        self.take()?;
        let other = self.value(CHOICE)?;
        let span = self.parts[condition].span.start..self.end;
        Ok(self.add(span, mark, PartKind::Choice(condition, one, other)))
    }

    /// A value with what stands before it.
    fn prefixed(&mut self) -> Result<usize, Mistake> {
        let (operator, binds) = match &self.token {
            Token::Sign("-") => (Operator::Negate, PREFIX),
            Token::Sign("!") => (Operator::Not, PREFIX),
            Token::Name(name) if name == "not" => (Operator::Not, NOT),
            Token::Sign("+") => {
                let help = "remove it: a value without a sign is the same";
                return Err(Mistake::new(
                    self.span.clone(),
                    "a `+` before a value does nothing",
                    help,
                ));
            }
            _ => return self.followed(),
        };
        let mark = self.take()?;
        let operand = self.value(binds)?;
        let span = mark.start..self.end;
        if operator == Operator::Negate
            && operand + 1 == self.parts.len()
            && let Part { kind: PartKind::Number(number), .. } = &mut self.parts[operand]
            && !number.starts_with('-')
        {
            number.insert(0, '-');
            self.parts[operand].span = span;
            return Ok(operand);
        }
        Ok(self.add(span, mark, PartKind::Operation(operator, vec![operand])))
    }

    /// A value with the members and indices behind it.
    fn followed(&mut self) -> Result<usize, Mistake> {
        let (mut part, start) = self.single()?;
        loop {
            if self.is(".") {
                self.take()?;
                let Token::Name(name) = self.token.clone() else {
                    return self.expected(
                        "a name behind `.`",
                        "such as `.x`, `.rgb` or the name of an output",
                    );
                };
                let mark = self.take()?;
                part = self.add(start..self.end, mark, PartKind::Member(part, name));
            } else if self.is("[") {
                part = self.element(part, start)?;
            } else {
                return Ok(part);
            }
        }
    }

    fn element(&mut self, of: usize, start: usize) -> Result<usize, Mistake> {
        let open = self.take()?;
        let index = match &self.token {
            Token::Number(number) => number.parse::<usize>().ok(),
            _ => None,
        };
        let Some(index) = index else {
            let help =
                "an index is known before shading; an `element` node chooses by a computed one";
            return self.expected("a whole number", help);
        };
        self.take()?;
        if !self.is("]") {
            return self.expected("`]`", "an index is one whole number");
        }
        let close = self.take()?;
        Ok(self.add(start..self.end, open.start..close.end, PartKind::Element(of, index)))
    }

    /// A value in itself, and where it starts, brackets included.
    fn single(&mut self) -> Result<(usize, usize), Mistake> {
        let start = self.span.start;
        let kind = match self.token.clone() {
            Token::Number(number) => PartKind::Number(number),
            Token::Text(text) => PartKind::Text(text),
            Token::Name(name) if name == "true" || name == "false" => {
                PartKind::Boolean(name == "true")
            }
            Token::Name(name) if !WORDS.contains(&name.as_str()) => {
                let mark = self.take()?;
                if self.is("(") {
                    return Ok((self.call(name, mark)?, start));
                }
                let part = self.add(mark.clone(), mark, PartKind::Name(name));
                return Ok((part, start));
            }
            Token::Sign("(") => {
                let open = self.take()?;
                let part = self.value(0)?;
                self.close(open)?;
                self.parts[part].span = start..self.end;
                return Ok((part, start));
            }
            Token::Sign("[") => {
                let help = "write `vector(x, y, z)` or `color(r, g, b)`";
                return Err(Mistake::new(
                    self.span.clone(),
                    "there are no lists in an expression",
                    help,
                ));
            }
            _ => {
                return self
                    .expected("a value", "a value is a number, a name, a function or `( … )`");
            }
        };
        let mark = self.take()?;
        Ok((self.add(mark.clone(), mark, kind), start))
    }

    /// Takes the `)` of a bracket that was opened.
    fn close(&mut self, open: Span) -> Result<(), Mistake> {
        if self.is(")") {
            return self.take().map(|_| ());
        }
        if self.token == Token::End {
            return Err(Mistake::new(open, "this `(` is never closed", "add a `)`"));
        }
        self.expected(
            "an operator or `)`",
            "put an operator between two values, or close the bracket",
        )
    }

    fn call(&mut self, name: String, mark: Span) -> Result<usize, Mistake> {
        let open = self.take()?;
        let mut arguments = Vec::new();
        while !self.is(")") {
            arguments.push(self.argument()?);
            if self.is(",") {
                let comma = self.take()?;
                if self.is(")") {
                    return Err(Mistake::new(
                        comma,
                        "an argument is missing behind this `,`",
                        "remove it",
                    ));
                }
            } else if !self.is(")") {
                if self.token == Token::End {
                    return Err(Mistake::new(open, "this `(` is never closed", "add a `)`"));
                }
                return self.expected("`,` or `)`", "arguments are parted by `,`");
            }
        }
        self.take()?;
        Ok(self.add(mark.start..self.end, mark, PartKind::Call(name, arguments)))
    }

    /// `value`, or `name: value`.
    fn argument(&mut self) -> Result<Argument, Mistake> {
        let mut name = None;
        if let Token::Name(word) = self.token.clone()
            && !WORDS.contains(&word.as_str())
            && let Ok((Token::Sign(":"), _)) = token::next(self.text, self.span.end)
        {
            let span = self.take()?;
            self.take()?;
            name = Some((word, span));
        }
        Ok(Argument { name, value: self.value(0)? })
    }
}
