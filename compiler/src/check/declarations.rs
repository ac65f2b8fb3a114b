//! Reading the declaration of a parameter, but for its default.

use std::collections::HashSet;
use std::ops::RangeInclusive;

use crate::diagnostics::{Code, shortened, synonyms};
use crate::document::{Member, Object, Reader, Value, ValueKind};
use crate::nodes::FINITE;
use crate::values::Type;

use super::keys;
use super::names::check_key;

/// What a declaration says its type is.
#[derive(Clone, Copy)]
enum Said {
    One(Type),
    Array,
    Struct,
}

impl Said {
    fn name(self) -> &'static str {
        match self {
            Said::One(value_type) => value_type.name(),
            Said::Array => keys::COMPOUNDS[0],
            Said::Struct => keys::COMPOUNDS[1],
        }
    }
}

/// A declaration, before its default is looked at.
pub(super) enum Declared<'d> {
    One(One<'d>),
    Array { of: Box<Declared<'d>>, value: &'d Value },
    Struct { members: Vec<(&'d Member, Declared<'d>)> },
}

/// The declaration of one value; none of what is wrong.
pub(super) struct One<'d> {
    pub value: &'d Value,
    pub value_type: Type,
    pub doc: Option<String>,
    pub unit: Option<String>,
    pub labels: Option<Vec<String>>,
    pub range: Option<RangeInclusive<f64>>,
    pub soft_range: Option<RangeInclusive<f64>>,
}

impl One<'_> {
    /// Bytes every part of this declaration keeps.
    pub fn bytes(&self) -> usize {
        let labels = self.labels.iter().flatten().map(|label| size_of::<String>() + label.len());
        let texts = [&self.doc, &self.unit].into_iter().flatten().map(String::len);
        labels.chain(texts).sum()
    }
}

/// Reads a declaration; `top` is one that may have a default.
pub(super) fn declaration<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    what: &str,
    top: bool,
) -> Option<Declared<'d>> {
    let object = Object::unchecked(reader, value, what)?;
    let mut choices: Vec<(&str, Said)> = Type::ALL
        .into_iter()
        .map(|value_type| (value_type.name(), Said::One(value_type)))
        .collect();
    choices.extend([Said::Array, Said::Struct].map(|said| (said.name(), said)));
    let said = object.required(reader, "type").and_then(|value| {
        let what = "the type of a parameter";
        if let ValueKind::Array(_) = value.kind {
            let message = format!("{what} must be a string, not {}", value.describe());
            let help = "an array is `\"type\": \"array\", \"of\": { \"type\": … }`";
            reader.report(Code::WRONG_KIND, value, message, help);
            return None;
        }
        reader.choice_or(value, what, &choices, synonyms::value_type)
    });
    let has_values = object.optional("values").is_some();
    let keys = keys::of_declaration(said.map(Said::name), has_values).into_iter();
    let keys = keys.filter(|key| top || key.name != "default");
    let keys: Vec<&str> = keys.map(|key| key.name).collect();
    reader.object(value, what, &keys);
    match said {
        Some(Said::One(value_type)) => one(reader, &object, value_type, what).map(Declared::One),
        Some(Said::Array) => {
            text(reader, &object, "doc");
            let of = object.required(reader, "of")?;
            let of = Box::new(declaration(reader, of, &format!("an element of {what}"), false)?);
            Some(Declared::Array { of, value })
        }
        Some(Said::Struct) => structure(reader, &object, what),
        None => {
            // Its other keys are looked at as far as they can be.
            one(reader, &object, Type::Integer, what);
            None
        }
    }
}

fn structure<'d>(reader: &mut Reader<'d>, object: &Object<'d>, what: &str) -> Option<Declared<'d>> {
    text(reader, object, "doc");
    let given = object.required(reader, "members")?;
    let mut members = Vec::new();
    let mut complete = true;
    for member in reader.members(given, "`members`")? {
        check_key(reader, member, "the name of a member");
        let what = format!("member `{}` of {what}", shortened(&member.key));
        match declaration(reader, &member.value, &what, true) {
            Some(declared) => members.push((member, declared)),
            None => complete = false,
        }
    }
    if members.is_empty() && complete {
        let message = format!("{what} has no members, so it holds nothing");
        reader.report(Code::EMPTY_RANGE, given, message, "declare at least one member");
        return None;
    }
    complete.then_some(Declared::Struct { members })
}

fn one<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    value_type: Type,
    what: &str,
) -> Option<One<'d>> {
    let doc = text(reader, object, "doc");
    let unit = text(reader, object, "unit");
    let labels = object.optional("values").and_then(|value| read_labels(reader, value));
    let range = match &labels {
        Some(labels) => Some(0.0..=(labels.len().saturating_sub(1)) as f64),
        None => read_range(reader, object, ("min", "max"), FINITE, what),
    };
    let outer = range.clone().unwrap_or(FINITE);
    let soft_range = read_range(reader, object, ("soft_min", "soft_max"), outer, what);
    Some(One { value: object.value, value_type, doc, unit, labels, range, soft_range })
}

fn text<'d>(reader: &mut Reader<'d>, object: &Object<'d>, key: &str) -> Option<String> {
    match object.optional(key) {
        None => Some(String::new()),
        Some(value) => reader.string(value, &format!("`{key}`")).map(str::to_owned),
    }
}

/// The names of an enumeration, at least one, each once.
fn read_labels<'d>(reader: &mut Reader<'d>, value: &'d Value) -> Option<Vec<String>> {
    let elements = reader.list(value, "`values`")?;
    if elements.is_empty() {
        let message = "an enumeration without values can take none";
        reader.report(Code::EMPTY_RANGE, value, message, "list the names of 0, 1, 2 …");
        return None;
    }
    let mut labels: Vec<String> = Vec::with_capacity(elements.len());
    let mut seen = HashSet::with_capacity(elements.len());
    for element in elements {
        let label = reader.string(element, "a value of an enumeration")?;
        if !seen.insert(label) {
            let message = format!("the value `{}` stands twice", shortened(label));
            reader.report(Code::DUPLICATE_KEY, element, message, "rename or remove one");
            return None;
        }
        labels.push(label.to_owned());
    }
    Some(labels)
}

/// The range between two keys, within `outer`; one that holds nothing is a finding.
fn read_range<'d>(
    reader: &mut Reader<'d>,
    object: &Object<'d>,
    (low_key, high_key): (&str, &str),
    outer: RangeInclusive<f64>,
    what: &str,
) -> Option<RangeInclusive<f64>> {
    let mut bound = |key: &str, otherwise: f64| match object.optional(key) {
        None => Some(otherwise),
        Some(value) => reader.number(value, &format!("`{key}` of {what}"), outer.clone()),
    };
    let low = bound(low_key, *outer.start());
    let high = bound(high_key, *outer.end());
    let (low, high) = (low?, high?);
    if low <= high {
        return Some(low..=high);
    }
    let value = object.optional(low_key).unwrap_or(object.value);
    let message =
        format!("{what} can take no value: `{low_key}` {low} is above `{high_key}` {high}");
    reader.report(Code::EMPTY_RANGE, value, message, "exchange them, or mend one");
    None
}
