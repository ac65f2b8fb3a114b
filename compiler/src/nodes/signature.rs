//! What is known about a node: everything the checker, the documentation and the engines ask.

use std::ops::RangeInclusive;

use crate::effects::Effect;
use crate::state::Field;

/// The type of an input, an output or an interface parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// True or false.
    Boolean,
    /// 32-bit signed integer.
    Integer,
    /// 32-bit floating point number.
    Scalar,
    /// Scene-linear Rec. 709 red, green, blue, and alpha.
    Color,
    /// Three numbers.
    Vector,
    /// A list of light names; uniform, never computed.
    Lights,
    /// The one type a generic node is used with: scalar, vector or color.
    Generic,
}

impl Type {
    /// Number of 32-bit words; none for what is uniform.
    pub fn width(self) -> usize {
        match self {
            Type::Boolean | Type::Integer | Type::Scalar => 1,
            Type::Vector => 3,
            Type::Color => 4,
            Type::Lights | Type::Generic => 0,
        }
    }

    /// The name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            Type::Boolean => "boolean",
            Type::Integer => "integer",
            Type::Scalar => "scalar",
            Type::Color => "color",
            Type::Vector => "vector",
            Type::Lights => "lights",
            Type::Generic => "scalar | vector | color",
        }
    }

    /// Whether a value of this type is converted without a node: integer to scalar, scalar (or
    /// integer) to color.
    pub fn converts_to(self, to: Type) -> bool {
        self == to
            || matches!(
                (self, to),
                (Type::Integer, Type::Scalar | Type::Color) | (Type::Scalar, Type::Color)
            )
    }
}

/// A literal, of a known type.
#[derive(Clone, Debug, PartialEq)]
pub enum Literal {
    /// See [`Type::Boolean`].
    Boolean(bool),
    /// See [`Type::Integer`].
    Integer(i32),
    /// See [`Type::Scalar`].
    Scalar(f32),
    /// See [`Type::Color`].
    Color([f32; 4]),
    /// See [`Type::Vector`].
    Vector([f32; 3]),
    /// Names of lights in the scene's order of mention; empty: every light of the scene.
    Lights(Vec<String>),
}

impl Literal {
    /// Its type.
    pub fn value_type(&self) -> Type {
        match self {
            Literal::Boolean(_) => Type::Boolean,
            Literal::Integer(_) => Type::Integer,
            Literal::Scalar(_) => Type::Scalar,
            Literal::Color(_) => Type::Color,
            Literal::Vector(_) => Type::Vector,
            Literal::Lights(_) => Type::Lights,
        }
    }

    /// Its words as the engines store them: floats by their bits, true as all bits set.
    pub fn words(&self) -> Vec<u32> {
        match self {
            Literal::Boolean(true) => vec![u32::MAX],
            Literal::Boolean(false) => vec![0],
            Literal::Integer(value) => vec![*value as u32],
            Literal::Scalar(value) => vec![value.to_bits()],
            Literal::Color(value) => value.iter().map(|x| x.to_bits()).collect(),
            Literal::Vector(value) => value.iter().map(|x| x.to_bits()).collect(),
            Literal::Lights(_) => Vec::new(),
        }
    }

    /// Converted as [`Type::converts_to`] allows.
    pub fn converted_to(&self, to: Type) -> Option<Literal> {
        Some(match (self, to) {
            (literal, to) if literal.value_type() == to => literal.clone(),
            (Literal::Integer(value), Type::Scalar) => Literal::Scalar(*value as f32),
            (Literal::Integer(value), Type::Color) => {
                let x = *value as f32;
                Literal::Color([x, x, x, 1.0])
            }
            (Literal::Scalar(x), Type::Color) => Literal::Color([*x, *x, *x, 1.0]),
            _ => return None,
        })
    }
}

/// What an input is when nothing is given for it.
#[derive(Clone, Debug)]
pub enum Default {
    /// It must be given.
    Required,
    /// A constant (also for a generic input: repeated over its components).
    Literal(Literal),
    /// A field of the state.
    State(Field),
    /// The first output of an implied node of this type, with its own defaults.
    Node(&'static str),
}

/// The input must be given.
pub fn required() -> Default {
    Default::Required
}
/// The input is a field of the state.
pub fn state(field: Field) -> Default {
    Default::State(field)
}
/// The input is what an implied node yields.
pub fn node(name: &'static str) -> Default {
    Default::Node(name)
}
impl From<bool> for Default {
    fn from(value: bool) -> Self {
        Default::Literal(Literal::Boolean(value))
    }
}
impl From<i32> for Default {
    fn from(value: i32) -> Self {
        Default::Literal(Literal::Integer(value))
    }
}
impl From<f64> for Default {
    fn from(value: f64) -> Self {
        Default::Literal(Literal::Scalar(value as f32))
    }
}
impl From<[f64; 3]> for Default {
    fn from(value: [f64; 3]) -> Self {
        Default::Literal(Literal::Vector(value.map(|x| x as f32)))
    }
}
impl From<[f64; 4]> for Default {
    fn from(value: [f64; 4]) -> Self {
        Default::Literal(Literal::Color(value.map(|x| x as f32)))
    }
}
impl From<Vec<String>> for Default {
    fn from(value: Vec<String>) -> Self {
        Default::Literal(Literal::Lights(value))
    }
}

/// Opaque black.
pub const BLACK: [f64; 4] = [0.0, 0.0, 0.0, 1.0];
/// Opaque white.
pub const WHITE: [f64; 4] = [1.0, 1.0, 1.0, 1.0];
/// Every finite number.
pub const FINITE: RangeInclusive<f64> = -(f32::MAX as f64)..=(f32::MAX as f64);
/// Every finite number not below zero.
pub const NOT_NEGATIVE: RangeInclusive<f64> = 0.0..=(f32::MAX as f64);
/// Every finite number above zero.
pub const POSITIVE: RangeInclusive<f64> = (f32::MIN_POSITIVE as f64)..=(f32::MAX as f64);

/// What should not arrive at an input: the conventions of `docs/numerics.md` say what comes of it, but
/// it is hardly what is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Avoid {
    /// Zero: the node divides by the input.
    Zero,
    /// Numbers below zero: the node raises the input to a power.
    Negative,
}

/// An input of a node. Inputs are listed in the order in which they are demanded.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name in graph files.
    pub name: &'static str,
    /// What it means, with its unit.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// What stands in when nothing is given.
    pub default: Default,
    /// Values that may arrive, per component (colours: r, g and b).
    pub range: RangeInclusive<f64>,
    /// What should not arrive, though it is within the range.
    pub avoid: Option<Avoid>,
    /// Demanded only where a guard over earlier inputs holds.
    pub guarded: bool,
    /// Evaluated in the scope or loop this node opens.
    pub scoped: bool,
}

/// An output of a node.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name in graph files.
    pub name: &'static str,
    /// What it means, with its unit.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// Values it takes while inputs are in range, per component.
    pub range: RangeInclusive<f64>,
}

/// How a node is evaluated.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A body over its inputs.
    Plain,
    /// No inputs; output by output, these fields of the state.
    Fields(Vec<Field>),
    /// A request to the renderer, whose arguments are the inputs and whose answer the outputs.
    Request(Effect),
    /// A body yields new values of these state fields, under which the scoped input is evaluated;
    /// the output is that input's value.
    Scope(Vec<Field>),
    /// The scoped input is evaluated once per light sample and summed in list order.
    LightLoop,
}

/// The signature of a node type.
#[derive(Clone, Debug)]
pub struct Signature {
    /// Name in graph files: lower case, words joined by `_`.
    pub name: &'static str,
    /// Group, which is also its folder.
    pub group: &'static str,
    /// What it does: first a sentence, then formula and numerical trap.
    pub doc: String,
    /// Paper, book or manual.
    pub source: &'static str,
    /// In order of demand.
    pub inputs: Vec<Input>,
    /// The first is what a connection means that names no output.
    pub outputs: Vec<Output>,
    /// How it is evaluated.
    pub kind: Kind,
}

impl Signature {
    /// Position of the input called `name`.
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|input| input.name == name)
    }

    /// Position of the output called `name`.
    pub fn output(&self, name: &str) -> Option<usize> {
        self.outputs.iter().position(|output| output.name == name)
    }

    /// Whether one of its inputs is [`Type::Generic`].
    pub fn is_generic(&self) -> bool {
        self.inputs.iter().any(|input| input.value_type == Type::Generic)
    }
}
