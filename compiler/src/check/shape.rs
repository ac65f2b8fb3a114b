//! What a parameter consists of, and what its parts are called.

use std::collections::HashMap;

use crate::diagnostics::listed;
use crate::document::Value;
use crate::values::Type;

use super::type_names::with_article;

/// What a parameter consists of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// One value.
    One(Type),
    /// Values by number.
    Array(Vec<Shape>),
    /// Values by name.
    Struct(Vec<(String, Shape)>),
}

impl Shape {
    /// With its article, for messages.
    pub fn describe(&self) -> String {
        match self {
            Shape::One(value_type) => with_article(*value_type),
            Shape::Array(elements) => match elements.first() {
                Some(Shape::One(of)) => format!("an array of {} × {}", elements.len(), of.name()),
                Some(Shape::Array(_)) => format!("an array of {} arrays", elements.len()),
                Some(Shape::Struct(_)) => format!("an array of {} structs", elements.len()),
                None => "an empty array".into(),
            },
            Shape::Struct(members) => {
                let names = members.iter().map(|(name, _)| name.as_str());
                format!("a struct of {}", listed(names))
            }
        }
    }

    /// Its parts by name, each one value, in order.
    pub fn parts(&self, name: &str) -> Vec<(String, Type)> {
        let mut parts = Vec::new();
        self.collect_parts(name.to_owned(), &mut parts);
        parts
    }

    fn collect_parts(&self, name: String, parts: &mut Vec<(String, Type)>) {
        match self {
            Shape::One(value_type) => parts.push((name, *value_type)),
            Shape::Array(elements) => {
                for (at, element) in elements.iter().enumerate() {
                    element.collect_parts(element_name(&name, at), parts);
                }
            }
            Shape::Struct(members) => {
                for (member, shape) in members {
                    shape.collect_parts(member_name(&name, member), parts);
                }
            }
        }
    }

    /// Whether a value of this shape fits where `to` is wanted: the same parts, each of a type that
    /// converts.
    pub fn fits(&self, to: &Shape) -> bool {
        match (self, to) {
            (Shape::One(from), Shape::One(to)) => from.converts_to(*to),
            (Shape::Array(from), Shape::Array(to)) => {
                from.len() == to.len() && from.iter().zip(to).all(|(from, to)| from.fits(to))
            }
            (Shape::Struct(from), Shape::Struct(to)) => {
                let from: HashMap<&str, &Shape> =
                    from.iter().map(|(name, shape)| (name.as_str(), shape)).collect();
                let same = |(name, to): &(String, Shape)| {
                    from.get(name.as_str()).is_some_and(|from| from.fits(to))
                };
                from.len() == to.len() && to.iter().all(same)
            }
            _ => false,
        }
    }

    /// The first part in which a value of this shape differs from what is wanted.
    pub fn difference(&self, to: &Shape, name: &str) -> Option<String> {
        let told = |from: &Shape, to: &Shape| {
            let part = if name.is_empty() { "it".into() } else { format!("its part `{name}`") };
            Some(format!("{part} must be {}, not {}", to.describe(), from.describe()))
        };
        match (self, to) {
            (Shape::Array(from), Shape::Array(to)) if from.len() == to.len() => {
                let mut pairs = from.iter().zip(to).enumerate();
                pairs.find_map(|(at, (from, to))| from.difference(to, &element_name(name, at)))
            }
            (Shape::Struct(from), Shape::Struct(to)) if from.len() == to.len() => {
                to.iter().find_map(|(member, to)| {
                    let name =
                        if name.is_empty() { member.clone() } else { member_name(name, member) };
                    match from.iter().find(|(of, _)| of == member) {
                        Some((_, from)) => from.difference(to, &name),
                        None => Some(format!("it lacks the part `{name}`")),
                    }
                })
            }
            (from, to) if from.fits(to) => None,
            (from, to) => told(from, to),
        }
    }

    /// How a value of it is written.
    pub fn form(&self) -> String {
        match self {
            Shape::One(value_type) => with_article(*value_type),
            Shape::Array(elements) => format!("write a list of {}", elements.len()),
            Shape::Struct(members) => match members.first() {
                Some((name, _)) => format!("write `{{ \"struct\": {{ \"{name}\": … }} }}`"),
                None => "write `{ \"struct\": {} }`".into(),
            },
        }
    }
}

/// The name of an element of an array.
pub(super) fn element_name(array: &str, at: usize) -> String {
    format!("{array}[{at}]")
}

/// The name of a member of a struct.
pub(super) fn member_name(of: &str, member: &str) -> String {
    format!("{of}.{member}")
}

/// The members of a struct literal, `{ "struct": { … } }`; none, and nothing said, for any other
/// value.
pub(super) fn struct_literal(value: &Value) -> Option<&Value> {
    value.get("struct")
}
