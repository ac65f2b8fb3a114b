//! Numbers and words, as JSON has them and as others do.

use crate::diagnostics::shortened;
use crate::document::numbers::is_number;

use super::characters::{ends_a_value, follows, is_of_a_word};
use super::lexer::{Kind, Lexer, Token};
use super::mistake::Mistake;

impl Lexer<'_> {
    /// A run of letters and digits; its first character is read.
    pub fn word(&mut self, start: usize) -> Token {
        let rest = &self.text[start..];
        let length = rest.find(|c| !is_of_a_word(c)).unwrap_or(rest.len());
        self.at = start + length;
        let run = &self.text[start..self.at];
        if matches!(run, "true" | "false" | "null") || is_number(run) {
            return self.token(Kind::Value, start);
        }
        let numeric = starts_a_number(run);
        // The closing quote of a string whose opening one is missing.
        if !numeric && self.byte(self.at) == Some(b'"') && ends_a_value(&self.text[self.at + 1..]) {
            self.at += 1;
            let mistake = Mistake::new(
                (start, self.at),
                "the opening quote of this string is missing",
                format!("write `\"{}\"`", shortened(run)),
            );
            let plain = run.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-'));
            let fixed = plain.then(|| format!("\"{run}\""));
            self.tell(Mistake { fix: fixed, ..mistake });
            return self.token(Kind::String, start);
        }
        match odd_value(run, numeric) {
            Some((message, help, fix)) => {
                self.tell(Mistake { fix, ..Mistake::new((start, self.at), message, help) });
                self.token(Kind::Value, start)
            }
            None => self.token(Kind::Word, start),
        }
    }

    /// Whether a call such as `vec3(1, 0, 0)` stands where the word is.
    pub fn is_call(&self, word: &Token) -> bool {
        self.byte(word.end) == Some(b'(')
    }

    /// What is wrong with a word that stands where a value should.
    pub fn no_value(&self, word: &Token) -> Mistake {
        let run = &self.text[word.start..word.end];
        let shown = shortened(run);
        if self.is_call(word) {
            let message = format!("JSON has no functions, such as `{shown}(…)`");
            return Mistake::new((word.start, word.end), message, "write a list: `[x, y, z]`");
        }
        let message = "this word is no JSON value";
        let help = if follows(self.character(word.end)) && !run.contains(['\\', '"']) {
            format!("write `\"{shown}\"`; without quotes JSON has numbers, true, false and null")
        } else {
            "write `true`, `false`, `null`, a number, or a string in double quotes".to_owned()
        };
        Mistake::new((word.start, word.end), message, help)
    }
}

fn starts_a_number(run: &str) -> bool {
    let bare = run.trim_start_matches(['+', '-']);
    let bare = bare.strip_prefix('.').unwrap_or(bare);
    bare.starts_with(|c: char| c.is_ascii_digit()) || matches!(run, "-" | "+" | ".")
}

type Odd = (String, String, Option<String>);

/// What a run that is no JSON value was meant as, where that can be told.
fn odd_value(run: &str, numeric: bool) -> Option<Odd> {
    let lower = run.to_lowercase();
    let bare = lower.trim_start_matches(['+', '-']);
    if matches!(bare, "nan" | "infinity" | "inf" | "1.#inf" | "1.#qnan") {
        let what = if bare == "nan" { "NaN" } else { "infinity" };
        let help = "write a finite number; the largest is 3.4028235e38";
        return Some((format!("JSON has no {what}"), help.into(), None));
    }
    let literal = match lower.as_str() {
        "true" | "false" | "null" => Some(lower.as_str()),
        "none" | "nil" => Some("null"),
        _ => None,
    };
    if let Some(literal) = literal {
        let help = format!("write `{literal}`");
        return Some((format!("`{run}` is no JSON value"), help, Some(literal.into())));
    }
    if matches!(lower.as_str(), "undefined" | "yes" | "no") {
        let help = "write `true`, `false` or `null`".to_owned();
        return Some((format!("`{run}` is no JSON value"), help, None));
    }
    if !numeric {
        return None;
    }
    Some(odd_number(run))
}

/// What is wrong with a number, and what it is in JSON where nothing else can be meant.
fn odd_number(run: &str) -> Odd {
    let (sign, bare) = match run.as_bytes().first() {
        Some(b'-') => ("-", &run[1..]),
        Some(b'+') => ("", &run[1..]),
        _ => ("", run),
    };
    if let Some((name, radix)) = base(bare) {
        let value = u64::from_str_radix(&bare[2..], radix).ok();
        let value = value.filter(|value| *value < 1 << 53).map(|value| format!("{sign}{value}"));
        let help = match &value {
            Some(value) => format!("write the number in decimal: `{value}`"),
            None => "write the number in decimal".into(),
        };
        return (format!("JSON has no {name} numbers"), help, value);
    }
    let digits = bare.replace('_', "");
    let whole_length = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    let (whole, rest) = digits.split_at(whole_length);
    let zeros = whole.len() > 1 && whole.starts_with('0');
    let whole = whole.trim_start_matches('0');
    let whole = if whole.is_empty() { "0" } else { whole };
    let rest = match rest.strip_suffix(['f', 'F']) {
        Some(shorter) => shorter,
        None => rest,
    };
    // `5.` and `5.e3` lack a digit; one zero changes nothing.
    let rest = match rest.strip_prefix('.') {
        Some(tail) if !tail.starts_with(|c: char| c.is_ascii_digit()) => format!(".0{tail}"),
        _ => rest.to_owned(),
    };
    let mended = format!("{sign}{whole}{rest}");
    // A number that starts with zero is octal elsewhere, where it may be another one.
    let octal = zeros && rest.is_empty() && !digits.contains(['8', '9']) && whole.len() > 1;
    let has_digit = bare.contains(|c: char| c.is_ascii_digit());
    let fix = Some(mended).filter(|mended| is_number(mended) && has_digit && !octal);
    let message = if run.starts_with('+') {
        "a number must not start with `+`"
    } else if zeros {
        "a number must not start with a zero"
    } else if bare.starts_with('.')
        || bare.contains('.') && fix.is_some() && !bare.contains('_') && !bare.ends_with(['f', 'F'])
    {
        "a number needs digits on both sides of its decimal point"
    } else if run.ends_with('%') {
        "JSON has no per cent"
    } else if fix.is_some() {
        "a number has digits, one point and an exponent, nothing else"
    } else {
        "this number is not complete"
    };
    let help = match &fix {
        Some(fix) => format!("write `{fix}`"),
        None if octal => format!("write `{sign}{whole}`, if no octal number is meant"),
        None => "write it like `-1.5e3`".into(),
    };
    (message.into(), help, fix)
}

/// The base of a number that says it by its prefix.
fn base(bare: &str) -> Option<(&'static str, u32)> {
    let (name, radix) = match bare.get(..2)? {
        "0x" | "0X" => ("hexadecimal", 16),
        "0b" | "0B" => ("binary", 2),
        "0o" | "0O" => ("octal", 8),
        _ => return None,
    };
    Some((name, radix))
}
