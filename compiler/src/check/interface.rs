//! Reading `interface`: the parameters of a phenomenon.

use std::ops::RangeInclusive;

use crate::diagnostics::{Code, Finding};
use crate::document::{Member, Object, Reader, Value, shortened, shown};
use crate::graph::Parameter;
use crate::nodes::{FINITE, Literal, Type};

use super::draft::{Draft, DraftParameter};
use super::{literals, nodes};

/// The keys of a parameter with numbers.
const NUMERIC_KEYS: [&str; 9] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor"];
/// The keys of an integer.
const INTEGER_KEYS: [&str; 10] =
    ["type", "default", "min", "max", "soft_min", "soft_max", "unit", "doc", "editor", "values"];
/// The keys of a parameter without an order.
const PLAIN_KEYS: [&str; 4] = ["type", "default", "doc", "editor"];

/// The types a parameter may have.
pub(super) const TYPES: [(&str, Type); 6] = [
    ("scalar", Type::Scalar),
    ("integer", Type::Integer),
    ("boolean", Type::Boolean),
    ("color", Type::Color),
    ("vector", Type::Vector),
    ("lights", Type::Lights),
];

/// Reads all parameters.
pub(super) fn read<'d>(reader: &mut Reader<'d>, value: Option<&'d Value>, draft: &mut Draft<'d>) {
    let Some(value) = value else { return };
    let Some(members) = reader.members(value, "`interface`") else { return };
    for member in members {
        nodes::check_key(reader, member, "the name of a parameter");
        draft.parameter_names.insert(&member.key, draft.parameters.len());
        let (value_type, parameter) = read_parameter(reader, member);
        draft.parameters.push(DraftParameter { member, value_type, parameter });
    }
}

fn read_parameter<'d>(
    reader: &mut Reader<'d>,
    member: &'d Member,
) -> (Option<Type>, Option<Parameter>) {
    let what = format!("parameter `{}`", shortened(&member.key));
    let Some(object) = Object::unchecked(reader, &member.value, &what) else { return (None, None) };
    let value_type = object
        .required(reader, "type")
        .and_then(|value| reader.choice(value, "the type of a parameter", &TYPES));
    let keys: &[&str] = match value_type {
        Some(Type::Boolean | Type::Lights) => &PLAIN_KEYS,
        Some(Type::Scalar | Type::Color | Type::Vector) => &NUMERIC_KEYS,
        _ => &INTEGER_KEYS,
    };
    reader.object(&member.value, &what, keys);
    let doc = text(reader, &object, "doc");
    let unit = text(reader, &object, "unit");
    let labels = object.optional("values").and_then(|value| read_labels(reader, value));
    let range = match &labels {
        Some(labels) => Some(0.0..=(labels.len().saturating_sub(1)) as f64),
        None => read_range(reader, &object, ("min", "max"), FINITE, &what),
    };
    let outer = range.clone().unwrap_or(FINITE);
    let soft_range = read_range(reader, &object, ("soft_min", "soft_max"), outer, &what);
    let Some(value_type) = value_type else { return (None, None) };
    let default = match object.optional("default") {
        None if value_type == Type::Lights => Some(Literal::Lights(Vec::new())),
        None => {
            reader.missing(object.value, &what, "default");
            None
        }
        Some(value) => read_default(reader, value, value_type, range.as_ref(), labels.as_deref()),
    };
    let parameter = || {
        Some(Parameter {
            name: member.key.clone(),
            doc: doc?,
            value_type,
            default: default?,
            range: range?,
            soft_range: soft_range?,
            unit: unit?,
            labels: labels.unwrap_or_default(),
        })
    };
    (Some(value_type), parameter())
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
    for element in elements {
        let label = reader.string(element, "a value of an enumeration")?;
        if labels.iter().any(|other| other == label) {
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

fn read_default<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    value_type: Type,
    range: Option<&RangeInclusive<f64>>,
    labels: Option<&[String]>,
) -> Option<Literal> {
    if let (Some(labels), crate::document::ValueKind::String(_)) = (labels, &value.kind) {
        let choices: Vec<(&str, i32)> =
            labels.iter().enumerate().map(|(at, label)| (label.as_str(), at as i32)).collect();
        return reader.choice(value, "`default`", &choices).map(Literal::Integer);
    }
    let literal = literals::read(reader, value, value_type, false, &|| "`default`".into())?;
    let range = range?;
    // Compared as kept, in 32 bits: a default of 0.1 is not below a minimum of 0.1.
    let inside = |x: f32| (*range.start() as f32) <= x && x <= (*range.end() as f32);
    let outside = match &literal {
        Literal::Integer(number) => !range.contains(&f64::from(*number)),
        Literal::Scalar(x) => !inside(*x),
        Literal::Vector(vector) => vector.iter().any(|x| !inside(*x)),
        Literal::Color(color) => color[..3].iter().any(|x| !inside(*x)),
        Literal::Boolean(_) | Literal::Lights(_) => false,
    };
    if !outside {
        return Some(literal);
    }
    let help = format!("give a default in {}, or widen `min` and `max`", shown(range));
    let place = reader.document.place(value);
    let message = format!("the default lies outside the parameter's range, {}", shown(range));
    reader.findings.push(Finding::new(Code::NUMBER_OUT_OF_RANGE, place, message, help));
    None
}
