//! Expressions as they are read: their parts, and what `where` binds.

use crate::check::keys::{EXPRESSION, EXPRESSION_KEYS};
use crate::check::limits::MAX_NODES;
use crate::check::names::{check_key, name_mistake};
use crate::diagnostics::{Code, Finding};
use crate::document::expression::{Mistake, Offsets, Part, Span, WORDS, parse as parse_text};
use crate::document::{Member, Reader, Value};

use super::sites::Site;

/// An expression that was read.
pub(super) struct Parsed<'d> {
    /// The object.
    pub value: &'d Value,
    /// What its node is called.
    pub name: String,
    /// The nodes it feeds.
    pub nodes: Vec<usize>,
    /// Its text, escapes resolved.
    pub text: &'d str,
    /// Its parts; none where it has a mistake.
    pub parts: Vec<Part>,
    /// Where its characters stand.
    pub offsets: Offsets,
    /// What `where` binds, in file order: each name is known to those after it.
    pub bindings: Vec<(&'d Member, Bound<'d>)>,
}

/// What a name stands for.
pub(super) enum Bound<'d> {
    /// Another expression.
    Expression(Parsed<'d>),
    /// A literal or a connection.
    Value(&'d Value),
}

impl Parsed<'_> {
    /// The place of a piece of the text, in bytes of the file.
    pub fn place(&self, span: &Span) -> (usize, usize) {
        self.offsets.place(span)
    }
}

/// Reads all of them, as far as a graph can hold what they become.
pub(super) fn parse<'d>(reader: &mut Reader<'d>, sites: Vec<Site<'d>>) -> Vec<Parsed<'d>> {
    let mut left = MAX_NODES;
    let all = sites.into_iter().map(|site| read(reader, site, &mut left));
    all.collect()
}

fn read<'d>(reader: &mut Reader<'d>, site: Site<'d>, left: &mut usize) -> Parsed<'d> {
    let Site { value, name, nodes } = site;
    let mut parsed = Parsed {
        value,
        name,
        nodes,
        text: "",
        parts: Vec::new(),
        offsets: Offsets::of("", 0, 0),
        bindings: Vec::new(),
    };
    let Some(object) = reader.object(value, EXPRESSION.what, &EXPRESSION_KEYS) else {
        return parsed;
    };
    let bound = object.optional("where");
    let members = bound.and_then(|bound| reader.members(bound, "`where`"));
    for member in members.into_iter().flatten() {
        check_bound(reader, member);
        let name = format!("{}.{}", parsed.name, member.key);
        let bound = match member.value.get("expression") {
            Some(_) => {
                let site = Site { value: &member.value, name, nodes: Vec::new() };
                Bound::Expression(read(reader, site, left))
            }
            None => Bound::Value(&member.value),
        };
        parsed.bindings.push((member, bound));
    }
    let Some(given) = object.optional("expression") else { return parsed };
    let Some(text) = reader.string(given, "`expression`") else { return parsed };
    parsed.text = text;
    parsed.offsets = Offsets::of(&reader.document.file.text, given.start, given.end);
    match parse_text(text) {
        Ok(parts) if parts.len() <= *left => {
            *left -= parts.len();
            parsed.parts = parts;
        }
        Ok(_) => too_many(reader, given, left),
        Err(mistakes) => mistakes.into_iter().for_each(|it| report(reader, &parsed, it)),
    }
    parsed
}

/// Reports a name that no expression could use.
fn check_bound(reader: &mut Reader<'_>, member: &Member) {
    let what = "a name under `where`";
    let key = member.key.as_str();
    let message = match key.chars().next() {
        _ if name_mistake(what, key).is_some() => return check_key(reader, member, what),
        _ if WORDS.contains(&key) => format!("{what} is `{key}`, a word of the language"),
        Some(first) if first.is_numeric() => format!("{what} begins with the digit {first:?}"),
        _ if key.contains('-') => format!("{what} has a `-`, which subtracts in expressions"),
        _ => return,
    };
    let help = "choose another: a letter or `_`, then letters, digits and `_`";
    reader.report_key(Code::BAD_NAME, member, message, help);
}

/// Told once: what comes after is as much too much.
fn too_many(reader: &mut Reader<'_>, value: &Value, left: &mut usize) {
    if std::mem::take(left) > 0 {
        let message = format!("the expressions of the file have more than {MAX_NODES} parts");
        reader.report(Code::TOO_MANY_NODES, value, message, "split it into several phenomena");
    }
}

fn report(reader: &mut Reader<'_>, parsed: &Parsed<'_>, mistake: Mistake) {
    let (start, end) = parsed.place(&mistake.span);
    let place = reader.document.place_of_bytes(start, end);
    let mut finding = Finding::new(Code::EXPRESSION_SYNTAX, place, mistake.message, mistake.help);
    finding.fix = mistake.fix.map(str::to_owned);
    reader.findings.push(finding);
}
