//! What is known about a node: everything the checker, the documentation and the engines ask.

use std::ops::RangeInclusive;

use crate::effects::Effect;
use crate::state::{Field, Iterated, Reduction};

use crate::values::{Literal, Name, Type};

use super::ports::Port;

/// What an input is when nothing is given for it.
#[derive(Clone, Debug)]
pub enum DefaultValue {
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
pub fn required() -> DefaultValue {
    DefaultValue::Required
}
/// The input is a field of the state.
pub fn state(field: Field) -> DefaultValue {
    DefaultValue::State(field)
}
/// The input is what an implied node yields.
pub fn node(name: &'static str) -> DefaultValue {
    DefaultValue::Node(name)
}
impl From<bool> for DefaultValue {
    fn from(value: bool) -> Self {
        DefaultValue::Literal(Literal::Boolean(value))
    }
}
impl From<i32> for DefaultValue {
    fn from(value: i32) -> Self {
        DefaultValue::Literal(Literal::Integer(value))
    }
}
impl From<f64> for DefaultValue {
    fn from(value: f64) -> Self {
        DefaultValue::Literal(Literal::Scalar(value as f32))
    }
}
impl From<[f64; 3]> for DefaultValue {
    fn from(value: [f64; 3]) -> Self {
        DefaultValue::Literal(Literal::Vector(value.map(|x| x as f32)))
    }
}
impl From<[f64; 4]> for DefaultValue {
    fn from(value: [f64; 4]) -> Self {
        DefaultValue::Literal(Literal::Color(value.map(|x| x as f32)))
    }
}
impl From<&str> for DefaultValue {
    fn from(value: &str) -> Self {
        DefaultValue::Literal(Literal::String(value.to_owned()))
    }
}
impl From<Literal> for DefaultValue {
    fn from(value: Literal) -> Self {
        DefaultValue::Literal(value)
    }
}
impl From<Vec<String>> for DefaultValue {
    fn from(value: Vec<String>) -> Self {
        DefaultValue::Literal(Literal::Lights(value))
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
    pub name: Name,
    /// What it means, with its unit.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// What stands in when nothing is given.
    pub default: DefaultValue,
    /// Values that may arrive, per component (colours: r, g and b).
    pub range: RangeInclusive<f64>,
    /// What its values are measured in, as `radians`; empty where nothing is to be said.
    pub unit: Name,
    /// Values that are usual, within the range; the range where nothing is to be said.
    pub soft_range: RangeInclusive<f64>,
    /// What should not arrive, though it is within the range.
    pub avoid: Option<Avoid>,
    /// Demanded only where a guard over earlier inputs holds.
    pub guarded: bool,
    /// Evaluated in the scope or loop this node opens.
    pub scoped: bool,
    /// A list of values of that type; only of [`Kind::List`] nodes.
    pub list: bool,
    /// Known when the graph is specialised: given by a literal or a parameter, never by a node, an
    /// integer in its range. Another value is other code.
    pub fixed: bool,
    /// Names of 0, 1, 2 … where the input is a choice; else empty.
    pub choices: &'static [&'static str],
    /// What the checker gives it where nothing is given, but another input is.
    pub implied: Option<Implied>,
}

/// What the checker gives an input where nothing is given, from what another input of the node is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Implied {
    /// The scope node in which the other input is evaluated; it gets the inputs that it shares with the node.
    pub scope: &'static str,
    /// The other input.
    pub of: &'static str,
    /// Whether the input is how much that changes with the step of the scope, by a node `slope`, and not its
    /// value there.
    pub slope: bool,
}

/// The names of [`Avoid`] in headers.
pub mod avoidable {
    pub use super::Avoid::{Negative as negative, Zero as zero};
}

impl Input {
    /// An input for every finite number of its type, always demanded.
    pub fn new(
        name: impl Into<Name>,
        doc: &[&str],
        value_type: Type,
        default: impl Into<DefaultValue>,
    ) -> Self {
        Self {
            name: name.into(),
            doc: super::paragraph(doc),
            value_type,
            default: default.into(),
            range: FINITE,
            unit: "".into(),
            soft_range: FINITE,
            avoid: None,
            guarded: false,
            scoped: false,
            list: false,
            fixed: false,
            choices: &[],
            implied: None,
        }
    }

    /// An input as a header declares it.
    pub fn of<P: Port>(name: &'static str, doc: &[&str], default: impl Into<DefaultValue>) -> Self {
        Self { fixed: P::FIXED, ..Self::new(name, doc, P::TYPE, default) }
    }

    /// The whole number it has by default; none if it has another default.
    pub fn default_number(&self) -> Option<i32> {
        match self.default {
            DefaultValue::Literal(Literal::Integer(number)) => Some(number),
            _ => None,
        }
    }

    /// A choice of these, 0 being the first.
    pub fn one_of(self, choices: &'static [&'static str]) -> Self {
        Self { choices, range: 0.0..=choices.len().saturating_sub(1) as f64, ..self }
    }

    /// With this range.
    pub fn within(self, range: RangeInclusive<f64>) -> Self {
        Self { range, ..self }
    }

    /// By default what another input is given, in a scope of this node type.
    pub fn under(self, (scope, of): (&'static str, &'static str)) -> Self {
        Self { implied: Some(Implied { scope, of, slope: false }), ..self }
    }

    /// By default how another input changes with the step of a scope of this node type.
    pub fn slope(self, (scope, of): (&'static str, &'static str)) -> Self {
        Self { implied: Some(Implied { scope, of, slope: true }), ..self }
    }

    /// In this unit.
    pub fn measured_in(self, unit: impl Into<Name>) -> Self {
        Self { unit: unit.into(), ..self }
    }

    /// With values usually in this range.
    pub fn usually(self, soft_range: RangeInclusive<f64>) -> Self {
        Self { soft_range, ..self }
    }

    /// Usual values, where they are narrower than the range.
    pub fn narrower(&self) -> Option<&RangeInclusive<f64>> {
        let (soft, range) = (&self.soft_range, &self.range);
        (soft.start() > range.start() || soft.end() < range.end()).then_some(soft)
    }

    /// With this to be avoided.
    pub fn avoiding(self, avoid: Avoid) -> Self {
        Self { avoid: Some(avoid), ..self }
    }

    /// Demanded only where its guard holds.
    ///
    /// # Panics
    ///
    /// If it has a guard already: there is one condition, and `&` joins two.
    pub fn guarded(self) -> Self {
        assert!(!self.guarded, "input `{}` has two conditions", self.name);
        Self { guarded: true, ..self }
    }

    /// Evaluated in the scope or loop of its node.
    pub fn scoped(self) -> Self {
        Self { scoped: true, ..self }
    }

    /// A list of values.
    pub fn list(self) -> Self {
        Self { list: true, ..self }
    }
}

/// An output of a node.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name in graph files.
    pub name: Name,
    /// What it means, with its unit.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// Values it takes while inputs are in range, per component.
    pub range: RangeInclusive<f64>,
}

impl Output {
    /// An output that may be any finite number.
    pub fn new(name: impl Into<Name>, doc: &[&str], value_type: Type) -> Self {
        Self { name: name.into(), doc: super::paragraph(doc), value_type, range: FINITE }
    }

    /// With this range.
    pub fn within(self, range: RangeInclusive<f64>) -> Self {
        Self { range, ..self }
    }
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
    /// The inputs before the scoped one say what is run over; the scoped one is evaluated once a turn,
    /// and its values become one.
    Loop(Iterated, Reduction),
    /// Over a list of values, as other nodes: the checker puts those in its place, so no engine
    /// meets it.
    List(ListForm),
}

impl Kind {
    /// What [`Type::Generic`] stands for in a node of this kind that has no body.
    pub fn generic(&self) -> &'static [Type] {
        match self {
            Kind::List(ListForm::Element) => &Type::COMPUTED,
            _ => &Type::GENERIC,
        }
    }
}

/// What a node over a list stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListForm {
    /// The value at an index: a `select` for each value but the last.
    Element,
    /// The sum in list order: an `add` for each value but the first.
    Sum,
    /// A value by position along stops: a `ramp_segment` for each value but the first, chosen by `select`.
    Ramp,
}

/// The signature of a node type.
#[derive(Clone, Debug)]
pub struct Signature {
    /// Name in graph files: lower case, words joined by `_`.
    pub name: Name,
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
    /// What [`Type::Generic`] may stand for.
    pub generic: Vec<Type>,
    /// A list that may be given in place of the inputs it has: then the node is the `element` of that list
    /// at its first input.
    pub or_list: Option<Input>,
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

    /// Every input there is to give: those it has, and the list in place of them.
    pub fn all_inputs(&self) -> impl Iterator<Item = &Input> {
        self.inputs.iter().chain(&self.or_list)
    }

    /// The types an input or output of this type may have.
    pub fn types_of(&self, value_type: Type) -> &[Type] {
        match value_type {
            Type::Generic => &self.generic,
            _ => Type::ALL
                .iter()
                .position(|&of| of == value_type)
                .map_or(&[], |at| &Type::ALL[at..=at]),
        }
    }

    /// Whether one of its inputs is [`Type::Generic`].
    pub fn is_generic(&self) -> bool {
        self.inputs.iter().any(|input| input.value_type == Type::Generic)
    }
}
