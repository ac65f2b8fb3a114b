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

/// What is no token.
pub(super) struct Unknown {
    /// Why it is none.
    pub mistake: Box<Mistake>,
    /// The token that is meant, where one is, with its place.
    pub meant: Option<(Token, Span)>,
}

impl From<Mistake> for Unknown {
    fn from(mistake: Mistake) -> Self {
        Self { mistake: mistake.into(), meant: None }
    }
}

/// The token that begins at `at`, behind spaces, with its place.
pub(super) fn next(text: &str, at: usize) -> Result<(Token, Span), Unknown> {
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
        return Err(foreign(start..start + 1, message, "**"));
    }
    if !(first == '<' && follows('>'))
        && let Some(sign) = SIGNS.into_iter().find(|sign| rest.starts_with(sign))
    {
        return Ok((Token::Sign(sign), start..start + sign.len()));
    }
    if let Some((sign, message, ours)) =
        FOREIGN.into_iter().find(|(sign, ..)| rest.starts_with(sign))
    {
        return Err(foreign(start..start + sign.len(), message, ours));
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
    }
    .into())
}

/// What others write for a sign.
fn foreign(span: Span, message: &str, ours: &'static str) -> Unknown {
    let meant = Some((Token::Sign(ours), span.clone()));
    Unknown { mistake: Mistake::mended(span, message, ours).into(), meant }
}

/// What is meant as some number.
fn no_number(span: Span, message: String, help: &str) -> Unknown {
    let meant = Some((Token::Number("1".into()), span.clone()));
    Unknown { mistake: Mistake::new(span, message, help).into(), meant }
}

fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// `0.5`, `.5`, `5.`, `1e-3`; the text it gives is a number of JSON.
fn number(rest: &str, start: usize) -> Result<(Token, Span), Unknown> {
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
        return Err(no_number(span, message, &help));
    }
    if whole > 1 && bytes[0] == b'0' {
        let message = format!("the number `{}` begins with 0", &rest[..end]);
        return Err(no_number(span, message, "write it without the leading zeros"));
    }
    let mut text = String::from(if whole == 0 { "0" } else { &rest[..whole] });
    if fraction > 0 {
        text.push_str(&rest[mantissa - fraction - 1..mantissa]);
    }
    text.push_str(&rest[mantissa..end]);
    Ok((Token::Number(text), span))
}

/// `'glossy'`; there are no escapes in it.
fn quoted(rest: &str, start: usize, quote: char) -> Result<(Token, Span), Unknown> {
    if let Some(length) = rest[1..].find(quote) {
        return Ok((Token::Text(rest[1..=length].into()), start..start + length + 2));
    }
    let help = format!("add `{quote}` behind it");
    let mistake = Mistake::new(start..start + 1, "this text has no closing quote", help);
    // All that follows may be meant as a part of it.
    let meant = Some((Token::Text(rest[1..].into()), start..start + rest.len()));
    Err(Unknown { mistake: mistake.into(), meant })
}
