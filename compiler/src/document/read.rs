//! Reading a file into a [`Document`].

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use jsonc_parser::ast;
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use crate::diagnostics::{Code, Finding, Place, SourceFile};

use super::mistakes;
use super::open::open_file;
use super::prescan::{MAX_FILE_BYTES, prescan};
use super::syntax;
use super::{Document, Member, Value, ValueKind};

/// Strict JSON: every leniency of the parser is off.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a file's bytes; `name` is how findings call the file.
///
/// # Errors
/// One finding: too large, not UTF-8, nested too deeply, or not JSON.
pub fn read(name: &str, bytes: &[u8]) -> Result<Document, Box<Finding>> {
    if bytes.len() > MAX_FILE_BYTES {
        return Err(too_large(name, bytes.len() as u64));
    }
    if let Some(finding) = utf16(name, bytes) {
        return Err(finding);
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => return Err(not_utf8(name, bytes, error.valid_up_to())),
    };
    let file = Arc::new(SourceFile::new(name, text));
    let text = file.text.as_str();
    let irregular = prescan(text);
    if let Some((at, irregularity)) = irregular
        && irregularity.is_past_a_limit()
    {
        return Err(syntax::irregular(&file, at, irregularity));
    }
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT);
    let refused = match (parsed, irregular) {
        (Ok(parsed), None) => match parsed.value {
            Some(value) => {
                return Ok(Document { file: file.clone(), root: convert(value), written: None });
            }
            None => return Err(syntax::empty(&file)),
        },
        (Err(error), Some((at, _))) if error.range().start < at => {
            syntax::unparsable(&file, &error)
        }
        (_, Some((at, irregularity))) => syntax::irregular(&file, at, irregularity),
        (Err(error), None) => syntax::unparsable(&file, &error),
    };
    // The scan says it better, where it recognises the mistake.
    Err(mistakes::all(&file).into_iter().next().map_or(refused, Box::new))
}

/// Every mistake of a file that [`read`] refused, given the first: a file that is no JSON may break its
/// rules in many places.
pub fn all_mistakes(first: Finding) -> Vec<Finding> {
    if first.code != Code::SYNTAX {
        return vec![first];
    }
    let all = mistakes::all(&first.place.file);
    if all.is_empty() { vec![first] } else { all }
}

/// Reads a file from disk: a regular one, so that nothing is waited for.
///
/// # Errors
/// One finding: unreadable, or what [`read`] finds.
pub fn read_file(path: &Path) -> Result<Document, Box<Finding>> {
    let name = path.display().to_string();
    let (file, bytes) = open_file(path).map_err(|error| unreadable(&name, &error))?;
    if bytes > MAX_FILE_BYTES as u64 {
        return Err(too_large(&name, bytes));
    }
    read_from(&name, file)
}

/// Reads what may be no file, such as standard input; `name` is how findings call it.
///
/// # Errors
/// One finding: unreadable, or what [`read`] finds.
pub fn read_from(name: &str, source: impl Read) -> Result<Document, Box<Finding>> {
    // Nobody says beforehand how much there is: never take more than the limit.
    let mut bytes = Vec::new();
    source
        .take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| unreadable(name, &error))?;
    read(name, &bytes)
}

fn convert(value: ast::Value<'_>) -> Value {
    let range = value.range();
    let kind = match value {
        ast::Value::NullKeyword(_) => ValueKind::Null,
        ast::Value::BooleanLit(literal) => ValueKind::Boolean(literal.value),
        ast::Value::NumberLit(literal) => ValueKind::Number(literal.value.to_owned()),
        ast::Value::StringLit(literal) => ValueKind::String(literal.value.into_owned()),
        ast::Value::Array(array) => ValueKind::Array(exactly(array.elements, convert)),
        ast::Value::Object(object) => ValueKind::Object(exactly(object.properties, member)),
    };
    Value { start: range.start, end: range.end, kind }
}

/// All of a list, in no more room than they take: collected, they would keep that of the list, which is twice as much in
/// a usual graph.
fn exactly<A, B>(of: Vec<A>, convert: impl FnMut(A) -> B) -> Vec<B> {
    let mut all = Vec::with_capacity(of.len());
    all.extend(of.into_iter().map(convert));
    all
}

fn member(property: ast::ObjectProp<'_>) -> Member {
    let range = property.name.range();
    let key = match property.name {
        ast::ObjectPropName::String(name) => name.value.into_owned(),
        ast::ObjectPropName::Word(name) => name.value.to_owned(),
    };
    Member { key, key_start: range.start, key_end: range.end, value: convert(property.value) }
}

fn in_empty_file(name: &str) -> Place {
    let file = Arc::new(SourceFile::new(name, ""));
    Place { file, start: 0, end: 0, path: String::new() }
}

fn too_large(name: &str, bytes: u64) -> Box<Finding> {
    Box::new(Finding::new(
        Code::FILE_TOO_LARGE,
        in_empty_file(name),
        format!("the file has {bytes} bytes; at most {MAX_FILE_BYTES} are read"),
        "split it into phenomena that use one another",
    ))
}

fn unreadable(name: &str, error: &std::io::Error) -> Box<Finding> {
    Box::new(Finding::new(
        Code::UNREADABLE_FILE,
        in_empty_file(name),
        format!("cannot read `{name}`: {error}"),
        "check the path and its permissions",
    ))
}

fn not_utf8(name: &str, bytes: &[u8], at: usize) -> Box<Finding> {
    // The excerpt shows what can be shown; the place stays right, because all before it is valid.
    let file = Arc::new(SourceFile::new(name, String::from_utf8_lossy(bytes)));
    let end = at + char::REPLACEMENT_CHARACTER.len_utf8();
    let place = Place { file, start: at, end, path: String::new() };
    let message = format!("the byte 0x{:02x} is not valid UTF-8 here", bytes[at]);
    Box::new(Finding::new(Code::NOT_UTF8, place, message, "save the file as UTF-8"))
}

/// The finding for a file in UTF-16, by its mark or by the zeros between its ASCII characters; none for
/// any other file. Its excerpt is the text.
fn utf16(name: &str, bytes: &[u8]) -> Option<Box<Finding>> {
    let ascii = |byte: u8| byte != 0 && byte < 0x80;
    let (marked, little) = match *bytes.get(..4)? {
        [0xff, 0xfe, ..] => (true, true),
        [0xfe, 0xff, ..] => (true, false),
        [a, 0, b, 0] if ascii(a) && ascii(b) => (false, true),
        [0, a, 0, b] if ascii(a) && ascii(b) => (false, false),
        _ => return None,
    };
    let units = bytes[if marked { 2 } else { 0 }..].chunks_exact(2).map(|unit| {
        let unit = [unit[0], unit[1]];
        if little { u16::from_le_bytes(unit) } else { u16::from_be_bytes(unit) }
    });
    let text: String =
        char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
    let end = text.chars().next().map_or(0, char::len_utf8);
    let file = Arc::new(SourceFile::new(name, text));
    let place = Place { file, start: 0, end, path: String::new() };
    let message = "the file is UTF-16, not UTF-8";
    Some(Box::new(Finding::new(Code::NOT_UTF8, place, message, "save the file as UTF-8")))
}
