//! Strings, and where those end that are not closed.

use crate::diagnostics::shortened;

use super::characters::{ends_a_value, follows, is_typographic, line_end};
use super::lexer::{Kind, Lexer, Token};
use super::mistake::{MAX_MISTAKES, Mistake};
use super::quotes::json;

/// How far the end of a string is looked for beyond where it should be.
const REACH: usize = 4096;

impl Lexer<'_> {
    /// A string that starts with `"`; the quote is read.
    pub fn string(&mut self, start: usize) -> Token {
        let mut within: Vec<Mistake> = Vec::new();
        let end = loop {
            match self.byte(self.at) {
                None | Some(b'\n' | b'\r') => return self.unclosed(start),
                Some(b'"') => break self.at + 1,
                Some(b'\\') => self.escape(&mut within),
                Some(control) if control < 0x20 => {
                    within.push(raw_control(self.at, control));
                    self.at += 1;
                }
                Some(_) => self.at += 1,
            }
            // A string of mistakes is told like a file of them.
            if within.len() > MAX_MISTAKES {
                within.truncate(MAX_MISTAKES);
            }
        };
        let content = &self.text[start + 1..end - 1];
        if let Some(length) = mixed_quotes(content, !follows(self.character(end))) {
            return self.closed_by_another(start, start + 1 + length);
        }
        if follows(self.character(end)) || self.byte(end) == Some(b'"') {
            within.into_iter().for_each(|mistake| self.tell(mistake));
            self.at = end;
            return self.token(Kind::String, start);
        }
        match structural_end(content) {
            Some(length) => self.not_closed(start, start + 1 + length),
            None => self.quote_within(start, end),
        }
    }

    /// An escape; what is wrong in it is noted.
    fn escape(&mut self, within: &mut Vec<Mistake>) {
        let start = self.at;
        let next = self.byte(start + 1);
        self.at += 1;
        match next {
            Some(b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't') => self.at += 1,
            Some(b'u') => {
                self.at += 1;
                self.unicode_escape(start, within);
            }
            // Caught as what they are.
            None | Some(0..0x20) => {}
            Some(b'\'') => {
                self.at += 1;
                let message = "this escape does not exist in JSON";
                let help = "write `'` without a backslash";
                within.push(Mistake::new((start, self.at), message, help).fixed_by("'"));
            }
            Some(_) => {
                self.at += self.character(self.at).map_or(0, char::len_utf8);
                let message = "this escape does not exist in JSON";
                let help = "JSON knows `\\\"` `\\\\` `\\/` `\\b` `\\f` `\\n` `\\r` `\\t` and `\\uXXXX`; a backslash itself is `\\\\`";
                within.push(Mistake::new((start, self.at), message, help));
            }
        }
    }

    /// The digits after `\u`, and those of the other half of a pair.
    fn unicode_escape(&mut self, start: usize, within: &mut Vec<Mistake>) {
        let digits = |at: usize| {
            let digits = self.text.get(at..at + 4)?;
            let hexadecimal = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
            u32::from_str_radix(digits, 16).ok().filter(|_| hexadecimal)
        };
        let Some(first) = digits(self.at) else {
            let message = "`\\u` needs four hexadecimal digits";
            within.push(Mistake::new((start, self.at), message, "write it like `\\u00e9`"));
            return;
        };
        let second = match self.text.get(self.at + 4..self.at + 6) {
            Some("\\u") => digits(self.at + 6),
            _ => None,
        };
        self.at += 4;
        match (first, second) {
            (0xd800..=0xdbff, Some(0xdc00..=0xdfff)) => self.at += 6,
            (0xd800..=0xdfff, _) => within.push(Mistake::new(
                (start, self.at),
                "this `\\u` escape names no character",
                "characters past U+FFFF are written as a pair `\\ud8xx\\udcxx`; one half alone means nothing",
            )),
            _ => {}
        }
    }

    /// A string with a line break, or the end of the file, before its closing quote.
    fn unclosed(&mut self, start: usize) -> Token {
        let stop = self.at;
        let content = &self.text[start + 1..stop];
        if let Some(length) = mixed_quotes(content, true) {
            return self.closed_by_another(start, start + 1 + length);
        }
        if let Some(end) = self.end_on_another_line(stop) {
            let message = "a string ends before its closing quote";
            let help = "close the string with `\"`, or write a line break as `\\n`";
            self.tell(Mistake::new((stop, stop + 1), message, help));
            self.at = end;
            let token = self.token(Kind::String, start);
            self.count_lines(start);
            return token;
        }
        let length = structural_end(content).unwrap_or(content.trim_end().len());
        self.not_closed(start, start + 1 + length)
    }

    /// Where a string that was broken over lines ends: what follows the line break is text, not JSON.
    fn end_on_another_line(&self, stop: usize) -> Option<usize> {
        let rest = self.text.get(stop..)?;
        let rest = &rest[..rest.floor_char_boundary(REACH)];
        let next = rest.trim_start();
        let is_text = next.starts_with(|c: char| c.is_alphabetic() || !c.is_ascii());
        let is_literal = ["true", "false", "null"].iter().any(|word| next.starts_with(word));
        let quote = next.find('"')?;
        let closes = follows(next[quote + 1..].chars().next());
        // A word and a quote on the same line is a key whose opening quote is missing.
        let is_key = !next[..quote].contains(char::is_whitespace)
            && next[quote + 1..].trim_start().starts_with(':');
        (is_text && !is_literal && closes && !is_key)
            .then(|| stop + (rest.len() - next.len()) + quote + 1)
    }

    /// A string whose end is where its closing quote is missing.
    fn not_closed(&mut self, start: usize, end: usize) -> Token {
        let message = "this string is probably not closed";
        let shown = shortened(&self.text[start + 1..end]);
        let help = format!("add the missing `\"` after `{shown}`");
        self.tell(Mistake::new((start, end), message, help));
        self.at = end;
        self.token(Kind::String, start)
    }

    /// A string that opens with `"` and closes with a quote of another kind.
    fn closed_by_another(&mut self, start: usize, end: usize) -> Token {
        let content = &self.text[start + 1..end];
        let quote = content.chars().next_back().unwrap_or('”');
        let inner = &content[..content.len() - quote.len_utf8()];
        let message = format!("this string opens with `\"` and closes with `{quote}`");
        let mistake = Mistake::new((start, end), message, "write `\"` on both ends");
        let fixed = format!("\"{}\"", json(inner));
        self.tell(mistake.fixed_by(fixed));
        self.at = end;
        self.token(Kind::String, start)
    }

    /// A quote inside of a string that seems to end it.
    fn quote_within(&mut self, start: usize, end: usize) -> Token {
        let line = &self.text[end..line_end(self.text, end)];
        let line = &line[..line.floor_char_boundary(REACH)];
        let last = line
            .match_indices('"')
            .find(|(at, _)| ends_a_value(&line[at + 1..]))
            .map(|(at, _)| end + at + 1);
        self.at = end;
        if let Some(last) = last {
            let message = "text follows this quote, so it does not end the string";
            let help = "write a quote inside of a string as `\\\"`";
            self.tell(Mistake::new((end - 1, end), message, help));
            self.at = last;
        }
        self.token(Kind::String, start)
    }
}

fn raw_control(at: usize, control: u8) -> Mistake {
    let place = (at, at + 1);
    if control == b'\t' {
        return Mistake::new(place, "a string holds a raw tab", "write it as `\\t`")
            .fixed_by("\\t");
    }
    let escape = format!("\\u{control:04x}");
    let message = format!("a string holds the control character 0x{control:02x}");
    let help = format!("write it as `{escape}`, or remove it");
    Mistake::new(place, message, help).fixed_by(escape)
}

/// Length of a string that was not closed, where JSON follows it in what was taken for its content:
/// `mix, ` or `type: `.
fn structural_end(content: &str) -> Option<usize> {
    let word = content.find(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '-' | '$')));
    if let Some(length) = word.filter(|length| *length > 0)
        && content[length..].trim_start().starts_with([':', '='])
    {
        return Some(length);
    }
    let length =
        content.trim_end_matches(|c: char| c.is_whitespace() || ",:{}[]".contains(c)).len();
    let tail = &content[length..];
    (tail.contains([',', ':', '{', '}', '[', ']'])).then_some(length)
}

/// Length of a string up to a typographic quote that closes it: JSON follows, and, but for where the
/// string is `wrong` anyway, another quote.
fn mixed_quotes(content: &str, wrong: bool) -> Option<usize> {
    content.char_indices().filter(|(_, c)| is_typographic(*c)).find_map(|(at, c)| {
        let end = at + c.len_utf8();
        let rest = content[end..].trim_start();
        let next = rest.strip_prefix([':', ',', '}', ']'])?;
        let goes_on = next.trim_start().starts_with(is_typographic) && rest.starts_with([':', ',']);
        (wrong || goes_on).then_some(end)
    })
}
