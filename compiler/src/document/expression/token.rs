//! The words and signs of an expression.

use super::{Mistake, Span};

/// A word or a sign.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// A number, as JSON writes it.
    Number(String),
    /// A name, or a word such as `and`.
    Name(String),
    /// A text between quotes.
    Text(String),
    /// A sign: an operator, a bracket, a comma.
    Sign(&'static str),
    /// The end of the text.
    End,
}

impl Token {
    /// What it is, for messages.
    pub fn describe(&self) -> String {
        match self {
            Token::Number(number) => format!("the number {number}"),
            Token::Name(name) => format!("`{name}`"),
            Token::Text(_) => "a text".into(),
            Token::Sign(sign) => format!("`{sign}`"),
            Token::End => "the end of the expression".into(),
        }
    }
}

/// Signs, longer ones before those they begin with.
const SIGNS: [&str; 21] = [
    "**", "<=", ">=", "==", "!=", "&&", "||", "+", "-", "*", "/", "%", "<", ">", "!", "?", ":",
    "(", ")", ",", ".",
];

/// What others write, and how it is written here.
const FOREIGN: [(&str, &str, &str); 7] = [
    ("<>", "there is no operator `<>`", "!="),
    ("=", "`=` assigns nothing here", "=="),
    ("&", "there is no operator `&`", "&&"),
    ("|", "there is no operator `|`", "||"),
    ("·", "there is no operator `·`", "*"),
    ("×", "there is no operator `×`", "*"),
    ("−", "this is no minus of ASCII", "-"),
];

/// The token that begins at `at`, behind spaces, with its place.
pub(super) fn next(text: &str, at: usize) -> Result<(Token, Span), Mistake> {
    let rest = text[at..].trim_start();
    let start = text.len() - rest.len();
    let Some(first) = rest.chars().next() else { return Ok((Token::End, start..start)) };
    let follows = |c: char| rest[first.len_utf8()..].starts_with(c);
    let digit = rest[first.len_utf8()..].starts_with(|c: char| c.is_ascii_digit());
    if first.is_ascii_digit() || first == '.' && digit {
        return number(rest, start);
    }
    if first.is_alphabetic() || first == '_' {
        let length = rest.find(|c: char| !is_of_name(c)).unwrap_or(rest.len());
        return Ok((Token::Name(rest[..length].into()), start..start + length));
    }
    if first == '\'' || first == '"' {
        return quoted(rest, start, first);
    }
    if first == '[' || first == ']' {
        return Ok((Token::Sign(if first == '[' { "[" } else { "]" }), start..start + 1));
    }
    if first == '^' {
        let message = "`^` is a power to some and \"exclusive or\" to others";
        return Err(Mistake::mended(start..start + 1, message, "**"));
    }
    if !(first == '<' && follows('>'))
        && let Some(sign) = SIGNS.into_iter().find(|sign| rest.starts_with(sign))
    {
        return Ok((Token::Sign(sign), start..start + sign.len()));
    }
    if let Some((sign, message, ours)) =
        FOREIGN.into_iter().find(|(sign, ..)| rest.starts_with(sign))
    {
        return Err(Mistake::mended(start..start + sign.len(), message, ours));
    }
    let span = start..start + first.len_utf8();
    Err(match first {
        ';' => Mistake::new(span, "an expression is one value, and ends without `;`", "remove it"),
        '{' | '}' => Mistake::new(
            span,
            format!("`{first}` has no meaning in an expression"),
            "group with `(` and `)`",
        ),
        '$' | '@' | '#' => {
            Mistake::new(span, format!("names are written without `{first}`"), "remove it")
        }
        _ => {
            let message = format!("the character {first:?} has no meaning in an expression");
            Mistake::new(span, message, "remove it")
        }
    })
}

fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// `0.5`, `.5`, `5.`, `1e-3`; the text it gives is a number of JSON.
fn number(rest: &str, start: usize) -> Result<(Token, Span), Mistake> {
    let bytes = rest.as_bytes();
    let digits =
        |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let whole = digits(0);
    let mut end = whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    let mantissa = end;
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits((end + 1 + sign).min(bytes.len()));
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    let span = start..start + end;
    let behind = rest[end..].find(|c: char| !is_of_name(c)).unwrap_or(rest.len() - end);
    if behind > 0 {
        let word = &rest[end..end + behind];
        let span = start..start + end + behind;
        let number = &rest[..end];
        let message = format!("`{number}{word}` is neither a number nor a name");
        let help = match word {
            "f" | "F" | "h" => format!("write `{number}`"),
            _ => format!("write `{number} * {word}` for a product"),
        };
        return Err(Mistake::new(span, message, help));
    }
    if whole > 1 && bytes[0] == b'0' {
        let message = format!("the number `{}` begins with 0", &rest[..end]);
        return Err(Mistake::new(span, message, "write it without the leading zeros"));
    }
    let mut text = String::from(if whole == 0 { "0" } else { &rest[..whole] });
    if fraction > 0 {
        text.push_str(&rest[mantissa - fraction - 1..mantissa]);
    }
    text.push_str(&rest[mantissa..end]);
    Ok((Token::Number(text), span))
}

/// `'glossy'`; there are no escapes in it.
fn quoted(rest: &str, start: usize, quote: char) -> Result<(Token, Span), Mistake> {
    match rest[1..].find(quote) {
        Some(length) => Ok((Token::Text(rest[1..=length].into()), start..start + length + 2)),
        None => {
            let span = start..start + 1;
            Err(Mistake::new(
                span,
                "this text has no closing quote",
                format!("add `{quote}` behind it"),
            ))
        }
    }
}
