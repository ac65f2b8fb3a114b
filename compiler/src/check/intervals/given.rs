//! What is known of what nodes are given: literals, parameters, fields of the state.

use std::ops::RangeInclusive;

use crate::emit::interval::{Interval, Whole, Word, tag};
use crate::graph::Parameter;
use crate::nodes::FINITE;
use crate::state::Field;
use crate::values::{Literal, Type};

use super::value::{Reached, Value, name_of, number};

/// Source of what lies in the point that is shaded: its fields vary together.
const POINT: u64 = 1;
/// Source of the side a surface was hit from.
const SIDE: u64 = 2;
/// Source of the time.
const TIME: u64 = 4;
/// Bits of sources given away above.
const FIXED: u32 = 3;

/// The bit of the source of that number; numbers past the last bit begin anew.
pub fn source(number: usize) -> u64 {
    1 << (FIXED + (number as u32) % (u64::BITS - FIXED))
}

/// Type of the words of a value.
pub fn word_type(value_type: Type) -> Type {
    match value_type {
        Type::Boolean => Type::Boolean,
        // A string is a number that stands for it.
        Type::Integer | Type::String => Type::Integer,
        _ => Type::Scalar,
    }
}

/// Whether ranges say nothing of a component: the alpha of a colour.
pub fn is_alpha(value_type: Type, component: usize) -> bool {
    matches!(value_type, Type::Color | Type::Shader) && component == 3
}

/// Every word of a type unknown.
pub fn unknown(value_type: Type, into: &mut Vec<Value>) {
    into.extend((0..value_type.width()).map(|_| Value::unknown(word_type(value_type))));
}

/// The words of a literal as an input of this type holds them, or of what a node takes by default.
pub fn literal(literal: &Literal, to: Type, into: &mut Vec<Value>) {
    let words = match (literal, to) {
        (Literal::Scalar(x), Type::Scalar) => {
            into.push(Value::constant(Type::Scalar, x.to_bits()));
            return;
        }
        _ => match literal.as_default(to) {
            Some(literal) => literal.words(),
            None => return unknown(to, into),
        },
    };
    into.extend(words.into_iter().map(|bits| Value::constant(word_type(to), bits)));
}

/// The words of a parameter, whose range is enforced where it is bound. `first_source` is the number of
/// the source of its first word.
pub fn parameter(parameter: &Parameter, at: usize, first_source: usize) -> Vec<Value> {
    let value_type = parameter.value_type;
    let defaults = parameter.default.words();
    let words = defaults.iter().enumerate();
    words
        .map(|(component, &default)| {
            let mut known = match (value_type, is_alpha(value_type, component)) {
                (Type::Boolean, _) => free(),
                (Type::Color, true) => within(Type::Scalar, &FINITE),
                _ if !value_type.is_numeric() => Value::unknown(word_type(value_type)),
                _ => within(value_type, &parameter.range),
            };
            // An open end is reached nowhere in particular, but the default is.
            let default = number(&known.word, default);
            if let (Some(Reached { low, high, .. }), Some(default)) = (known.reached, default) {
                known.reached = Some(Reached::all(low.min(default), high.max(default)));
            }
            let constant =
                known.reached.is_some_and(|reached| !reached.varies()) && known.word.is_point();
            known.sources = if constant { 0 } else { source(first_source + component) };
            known.named(name_of(const { tag("parameter") }, at, component))
        })
        .collect()
}

/// The words of a field of the state.
pub fn field(field: Field, into: &mut Vec<Value>) {
    let value_type = field.value_type();
    let at = Field::ALL.iter().position(|&other| other == field).unwrap_or_default();
    let (sources, reached) = match field {
        Field::InvNormal => (SIDE, None),
        Field::Time => (TIME, Some(Reached::all(0.0, 1.0))),
        Field::Direction | Field::Normal | Field::NormalGeom | Field::LightDirection => {
            (POINT, Some(Reached::all(-1.0, 1.0)))
        }
        // Above 0 only under a bent normal.
        Field::DotNd => (POINT, Some(Reached::all(-1.0, 0.0))),
        Field::RayType => (POINT, Some(Reached::all(0.0, 1.0))),
        Field::ReflectionLevel | Field::RefractionLevel => (POINT, Some(Reached::all(0.0, 1.0))),
        // Where nothing sets them.
        Field::Ior | Field::IorIn => (POINT, Some(Reached::all(0.0, 0.0))),
        _ => (POINT, None),
    };
    for component in 0..value_type.width() {
        let known = match (value_type, field.range()) {
            (Type::Boolean, _) => free(),
            (_, Some(range)) => Value { reached, ..within(value_type, &range) },
            (_, None) => Value { reached, ..Value::unknown(word_type(value_type)) },
        };
        into.push(Value { sources, ..known }.named(name_of(const { tag("field") }, at, component)));
    }
}

/// Truth that comes to be both.
pub fn free() -> Value {
    Value { reached: Some(Reached::all(0.0, 1.0)), ..Value::unknown(Type::Boolean) }
}

/// A value of a range, which is reached between its ends; an open end is not.
pub fn within(value_type: Type, range: &RangeInclusive<f64>) -> Value {
    let (low, high) = (*range.start(), *range.end());
    let word = match value_type {
        Type::Integer => {
            let (low, high) = (low.ceil() as i32, high.floor() as i32);
            Word::Integer(Whole { low, high: high.max(low), ..Whole::ANYTHING })
        }
        _ => Word::Number(Interval::between(low as f32, high as f32, 0, 0)),
    };
    let open = |end: f64| end.abs() >= f64::from(f32::MAX) || end.abs() >= f64::from(i32::MAX);
    let reached = match (open(low), open(high)) {
        (true, true) => None,
        (false, true) => Some(Reached::all(low as f32, low as f32)),
        (true, false) => Some(Reached::all(high as f32, high as f32)),
        (false, false) => Some(Reached::all(low as f32, high as f32)),
    };
    Value { word, reached, ..Value::unknown(word_type(value_type)) }
}

/// Words of one type as an input of another takes them; see [`Type::converts_to`].
pub fn converted(words: &[Value], from: Type, to: Type, into: &mut Vec<Value>) {
    match (from, to) {
        (from, to) if from == to => into.extend_from_slice(words),
        (Type::Integer, Type::Scalar) => into.extend(words.iter().map(|word| word.to_real())),
        (Type::Color, Type::Shader) => into.extend_from_slice(words),
        (Type::Integer | Type::Scalar, Type::Color) if !words.is_empty() => {
            let grey = words[0].to_real();
            into.extend([grey; 3]);
            into.push(Value::constant(Type::Scalar, 1.0_f32.to_bits()));
        }
        _ => unknown(to, into),
    }
}
