//! What a part of an expression comes to.

use crate::document::{Member, Value, ValueKind};
use crate::nodes::NodeType;
use crate::values::Type;

/// What a part comes to: JSON that may stand where a connection stands, and what it is.
#[derive(Clone)]
pub(super) struct Operand {
    /// What may be written for it; of no meaning where it is broken.
    pub json: ValueKind,
    /// What it is.
    pub is: Is,
}

/// What an operand is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Is {
    /// Something that was told of, or is told of elsewhere.
    Broken,
    /// A number as written, which suits inputs of several types.
    Number,
    /// A list of three numbers: a colour, or a vector among vectors.
    Triple,
    /// A text: a string, or the word of a choice.
    Text,
    /// A value of a type.
    Of(Type),
    /// A node, by its name: its first output, unless one is named behind it.
    Node(String, NodeType, Option<Type>),
    /// An array or a struct of the interface.
    Compound(usize),
    /// A map, by its name: a list, one turn of which is named by an index.
    Turns(String),
}

/// What arrives where a value is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Arrives {
    /// A number as written.
    Number,
    /// Three numbers as written.
    Triple,
    /// A text.
    Text,
    /// A value of a type.
    Of(Type),
}

impl Operand {
    /// What nothing more is said of.
    pub fn broken() -> Self {
        Self { json: ValueKind::Null, is: Is::Broken }
    }

    /// A value of a type.
    pub fn of(json: ValueKind, value_type: Type) -> Self {
        Self { json, is: Is::Of(value_type) }
    }
}

impl Arrives {
    /// Whether it is one number.
    pub fn is_scalar(self) -> bool {
        matches!(self, Arrives::Number | Arrives::Of(Type::Scalar | Type::Integer))
    }

    /// The type it has by itself.
    pub fn own(self) -> Type {
        match self {
            Arrives::Number => Type::Scalar,
            Arrives::Triple => Type::Color,
            Arrives::Text => Type::String,
            Arrives::Of(value_type) => value_type,
        }
    }

    /// What numbers are computed as that come together: the widest. None where they cannot, or are no numbers.
    pub fn joined(all: &[Arrives]) -> Option<Type> {
        let has = |value_type: Type| all.contains(&Arrives::Of(value_type));
        let numeric = all.iter().all(|it| {
            it.is_scalar()
                || *it == Arrives::Triple
                || it.own() == Type::Vector
                || it.own() == Type::Color
        });
        match (has(Type::Color), has(Type::Vector), all.contains(&Arrives::Triple)) {
            _ if !numeric => None,
            (true, true, _) => None,
            (true, false, _) | (false, false, true) => Some(Type::Color),
            (false, true, _) => Some(Type::Vector),
            (false, false, false)
                if has(Type::Integer) && all.iter().all(|it| it.own() == Type::Integer) =>
            {
                Some(Type::Integer)
            }
            (false, false, false) => Some(Type::Scalar),
        }
    }
}

/// The type an output has.
pub(super) fn settled(value_type: Type, generic: Option<Type>) -> Option<Type> {
    match value_type {
        Type::Generic => generic,
        known => Some(known),
    }
}

/// A connection of one or two members, whose places are set when it is used.
pub(super) fn connection(key: &str, name: &str, output: Option<&str>) -> ValueKind {
    let text = |text: &str| Value { start: 0, end: 0, kind: ValueKind::String(text.into()) };
    let mut members = vec![placed_member(key, text(name))];
    members.extend(output.map(|output| placed_member("output", text(output))));
    ValueKind::Object(members)
}

/// A member whose key has the place of its value.
pub(super) fn placed_member(key: &str, value: Value) -> Member {
    Member { key: key.into(), key_start: value.start, key_end: value.end, value }
}
