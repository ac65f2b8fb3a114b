//! What is drawn: cards with sockets, and wires between them, before anything has a place.

use crate::values::{Name, Type};

use super::implied::{Badge, Implied};
use super::values::Value;

/// All that is drawn of a graph: its parameters first, then its nodes, then its roots, then its
/// outputs.
pub(super) struct Diagram<'a> {
    /// Name of the graph.
    pub name: &'a str,
    /// Boxes.
    pub cards: Vec<Card<'a>>,
    /// Connections.
    pub wires: Vec<Wire>,
    /// How many of the cards are parameters.
    pub parameters: usize,
    /// How many of the cards are nodes.
    pub nodes: usize,
}

/// What a card stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A parameter of the interface.
    Parameter,
    /// A node.
    Node,
    /// A root.
    Root,
}

/// A box.
#[derive(Clone)]
pub(super) struct Card<'a> {
    /// What it stands for.
    pub role: Role,
    /// Its name.
    pub title: &'a str,
    /// Its type.
    pub subtitle: &'a str,
    /// A longer text for those who point at it.
    pub doc: &'a str,
    /// What it asks of the renderer, or does to the state.
    pub badge: Option<Badge>,
    /// Why it is never evaluated; none where it is.
    pub dead: Option<Dead>,
    /// For parameters: the default.
    pub value: Option<Value>,
    /// Left side, from the top.
    pub inputs: Vec<InputSocket>,
    /// Right side, from the top: those in use.
    pub outputs: Vec<OutputSocket<'a>>,
    /// For the box of an expression: which of the panels beside the drawing shows its nodes.
    pub opens: Option<usize>,
}

/// Why something is never evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dead {
    /// No root reaches it.
    Unreached,
    /// Roots reach it only through inputs that constants rule out.
    RuledOut,
}

/// An input.
#[derive(Clone)]
pub(super) struct InputSocket {
    /// Its name.
    pub name: Name,
    /// Its type, generic ones settled.
    pub value_type: Type,
    /// Evaluated only where needed.
    pub guarded: bool,
    /// Evaluated under a changed state, or many times.
    pub scoped: bool,
    /// Whether it is never evaluated, because constants decide its guard.
    pub ruled_out: bool,
    /// What stands beside the name.
    pub given: Given,
}

/// Where an input's value comes from, as far as it is told in its row.
#[derive(Clone)]
pub(super) enum Given {
    /// A wire, which tells it.
    Wire,
    /// A parameter of this name.
    Parameter(String),
    /// A literal.
    Literal(Value),
    /// A literal that is the default of the signature.
    Default(Value),
    /// A default that is evaluated: a field of the state, or a node without a box.
    Implied(Implied),
}

/// An output in use.
#[derive(Clone)]
pub(super) struct OutputSocket<'a> {
    /// Its name; empty for a parameter.
    pub name: &'a str,
    /// Its type, generic ones settled.
    pub value_type: Type,
}

/// A connection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wire {
    /// Card and position in its outputs.
    pub from: (usize, usize),
    /// Card and position in its inputs.
    pub to: (usize, usize),
    /// Whether the value changes type on arrival.
    pub converts: bool,
    /// Whether nothing is ever evaluated through it.
    pub dead: bool,
    /// Whether it is dead because of its own input, which constants rule out.
    pub ruled_out: bool,
}

impl InputSocket {
    /// What its default asks of the renderer.
    pub fn asks(&self) -> Option<Badge> {
        match &self.given {
            Given::Implied(implied) if !self.ruled_out => implied.asks.clone(),
            _ => None,
        }
    }
}
