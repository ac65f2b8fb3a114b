//! Syntax findings: what the parser or the prescan met, said so that it can be mended.

use std::sync::Arc;

use jsonc_parser::ParseStringErrorKind;
use jsonc_parser::errors::{ParseError, ParseErrorKind};

use crate::diagnostics::{Code, Finding, Place, SourceFile};

use super::prescan::{Irregularity, MAX_DEPTH, MAX_VALUES};

fn finding(
    file: &Arc<SourceFile>,
    code: Code,
    (start, end): (usize, usize),
    message: String,
    help: &str,
) -> Box<Finding> {
    let text = &file.text;
    let start = text.floor_char_boundary(start.min(text.len()));
    let end = text.ceil_char_boundary(end.min(text.len())).max(start);
    let place = Place { file: file.clone(), start, end, path: String::new() };
    Box::new(Finding::new(code, place, message, help))
}

pub(super) fn empty(file: &Arc<SourceFile>) -> Box<Finding> {
    finding(
        file,
        Code::SYNTAX,
        (0, file.text.len().min(1)),
        "the file is empty".into(),
        "a graph or a scene is one JSON object: start with `{ \"phenomenon\": \"name\" … }`",
    )
}

pub(super) fn irregular(
    file: &Arc<SourceFile>,
    at: usize,
    irregularity: Irregularity,
) -> Box<Finding> {
    let (code, end, message, help) = match irregularity {
        Irregularity::TooDeep => (
            Code::TOO_DEEP,
            at + 1,
            format!("lists and objects are nested more than {MAX_DEPTH} deep"),
            "no graph or scene needs such nesting; look for an unclosed bracket",
        ),
        Irregularity::TooManyValues => (
            Code::FILE_TOO_LARGE,
            at + 1,
            format!("the file has more than {MAX_VALUES} values"),
            "split it into phenomena that use one another",
        ),
        Irregularity::ControlInString(byte) => (
            Code::SYNTAX,
            at + 1,
            match byte {
                b'\n' | b'\r' => "a string ends before its closing quote".into(),
                b'\t' => "a string holds a raw tab".into(),
                _ => format!("a string holds the control character 0x{byte:02x}"),
            },
            match byte {
                b'\n' | b'\r' => "close the string with `\"`, or write a line break as `\\n`",
                b'\t' => "write it as `\\t`",
                _ => "write it as `\\u00XX`, or remove it",
            },
        ),
        Irregularity::Stray('\u{feff}') => (
            Code::SYNTAX,
            at + 3,
            "the file has a byte order mark, which JSON does not allow".into(),
            "save the file as UTF-8 without BOM",
        ),
        Irregularity::Stray(character) => (
            Code::SYNTAX,
            at + character.len_utf8(),
            format!("unexpected character {character:?}"),
            "outside strings JSON has only ASCII punctuation, numbers, true, false and null",
        ),
    };
    finding(file, code, (at, end), message, help)
}

pub(super) fn unparsable(file: &Arc<SourceFile>, error: &ParseError) -> Box<Finding> {
    use ParseErrorKind as Kind;
    let range = error.range();
    let mut place = (range.start, range.end);
    let (message, help) = match error.kind() {
        Kind::CommentsNotAllowed | Kind::UnterminatedCommentBlock => (
            "JSON has no comments".into(),
            "move the text into a `\"doc\"` of the node or parameter",
        ),
        Kind::TrailingCommasNotAllowed => {
            ("a comma after the last element".into(), "remove the comma")
        }
        Kind::ExpectedComma => ("a comma is missing here".into(), "separate elements with `,`"),
        Kind::ExpectedColonAfterObjectKey => {
            ("a `:` is missing after this key".into(), "write `\"key\": value`")
        }
        Kind::ExpectedObjectValue => ("this key has no value".into(), "write `\"key\": value`"),
        Kind::ExpectedStringObjectProperty => {
            ("a key must be a string in double quotes".into(), "write `\"key\": value`")
        }
        Kind::SingleQuotedStringsNotAllowed => {
            ("a string must stand in double quotes".into(), "write `\"` instead of `'`")
        }
        Kind::UnterminatedObject => {
            place = (range.start, range.start + 1);
            ("this `{` is never closed".into(), "add the missing `}`")
        }
        Kind::UnterminatedArray => {
            place = (range.start, range.start + 1);
            ("this `[` is never closed".into(), "add the missing `]`")
        }
        Kind::String(ParseStringErrorKind::UnterminatedStringLiteral) => {
            place = (range.start, range.start + 1);
            ("this string is never closed".into(), "add the missing `\"`")
        }
        Kind::String(ParseStringErrorKind::InvalidUnicodeEscapeSequence(_)) => (
            "this `\\u` escape names no character".into(),
            "characters past U+FFFF are written as a pair `\\ud8xx\\udcxx`; one half alone means nothing",
        ),
        Kind::String(ParseStringErrorKind::ExpectedFourHexDigits) => {
            ("`\\u` needs four hexadecimal digits".into(), "write it like `\\u00e9`")
        }
        Kind::String(_) => (
            "this escape does not exist in JSON".into(),
            "JSON knows `\\\"` `\\\\` `\\/` `\\b` `\\f` `\\n` `\\r` `\\t` and `\\uXXXX`; a backslash itself is `\\\\`",
        ),
        Kind::HexadecimalNumbersNotAllowed => {
            ("JSON has no hexadecimal numbers".into(), "write the number in decimal")
        }
        Kind::UnaryPlusNumbersNotAllowed => {
            ("a number must not start with `+`".into(), "remove the `+`")
        }
        Kind::BareDecimalPointNumbersNotAllowed => (
            "a number needs digits on both sides of its decimal point".into(),
            "write `0.5` or `5.0`",
        ),
        Kind::NonFiniteNumbersNotAllowed => {
            ("infinity and NaN are no JSON numbers".into(), "write a finite number")
        }
        Kind::ExpectedDigit
        | Kind::ExpectedDigitFollowingNegativeSign
        | Kind::ExpectedPlusMinusOrDigitInNumberLiteral => {
            ("this number is not complete".into(), "write it like `-1.5e3`")
        }
        Kind::MultipleRootJsonValues => (
            "the file goes on after its value".into(),
            "remove what follows; a file holds one object",
        ),
        Kind::UnexpectedWord => (
            "this word is no JSON value".into(),
            "write `true`, `false`, `null`, a number, or a string in double quotes",
        ),
        Kind::NestingDepthExceeded => {
            (format!("lists and objects are nested more than {MAX_DEPTH} deep"), "")
        }
        Kind::UnexpectedComma => {
            ("an element is missing before this comma".into(), "remove the comma")
        }
        Kind::UnexpectedCloseBrace => {
            ("this `}` closes nothing".into(), "remove it, or close `[` first")
        }
        Kind::UnexpectedCloseBracket => {
            ("this `]` closes nothing".into(), "remove it, or close `{` first")
        }
        Kind::UnexpectedTokenInObject => {
            ("a key in double quotes must stand here".into(), "write `\"key\": value`")
        }
        Kind::UnexpectedColon => {
            ("a `:` has no place here".into(), "a list holds values only; use `{ }` for keys")
        }
        _ => ("unexpected text".into(), "remove it, or put it in double quotes"),
    };
    finding(file, Code::SYNTAX, place, message, help)
}
