//! A graph whose names are resolved, types settled and inputs bound.

use std::ops::RangeInclusive;

use crate::nodes::{FINITE, NodeLibrary, NodeType};
use crate::values::{Literal, Type};

use super::{Requirements, RootKind};

/// A phenomenon without findings of severity error.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// The node types its nodes are of: those it was checked with.
    pub library: NodeLibrary,
    /// Name of the phenomenon.
    pub name: String,
    /// Its doc.
    pub doc: String,
    /// Its version; 0 where the file gives none.
    pub version: i32,
    /// What it requires of the renderer.
    pub requirements: Requirements,
    /// Parameters of the interface, in file order; arrays and structs part by part, called
    /// `layers[2].tint`.
    pub parameters: Vec<Parameter>,
    /// Named values of parameters, in file order.
    pub presets: Vec<Preset>,
    /// Nodes; connections between them form no cycle.
    pub nodes: Vec<Node>,
    /// Roots, at most one for each shader type.
    pub roots: Vec<Root>,
    /// Values it offers where it is a node, beside that of its root, in file order.
    pub outputs: Vec<Output>,
    /// Inputs that are never evaluated, as literals and the ranges of parameters prove: positions of a
    /// node and of one of its inputs, ascending. For those who look at the graph; engines find out by
    /// themselves.
    pub ruled_out: Vec<(usize, usize)>,
    /// The expressions of the file and of the phenomena in it, for those who look at the graph. Where there are none
    /// the nodes they became are drawn one by one.
    pub expressions: Vec<Expression>,
}

/// An expression that was written out as nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expression {
    /// What the node of its value is called; the others have `#` and a number behind it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// An interface parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its doc.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// Its default, of that type.
    pub default: Literal,
    /// Values it may be bound to, per component.
    pub range: RangeInclusive<f64>,
    /// Values an editor offers; within `range`.
    pub soft_range: RangeInclusive<f64>,
    /// Unit of the value, empty where it has none.
    pub unit: String,
    /// For an enumeration, which is an integer: the names of 0, 1, 2 …; else empty.
    pub labels: Vec<String>,
}

/// Values of some parameters of a phenomenon, under a name.
#[derive(Clone, Debug)]
pub struct Preset {
    /// Its name.
    pub name: String,
    /// Parameters, or parts of them, with their values, which suit them; the others keep their defaults.
    pub values: Vec<(String, Literal)>,
}

/// A node of a graph.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name; inside nested phenomena joined by `/`.
    pub name: String,
    /// Its type in [`Graph::library`].
    pub node_type: NodeType,
    /// Position in [`crate::nodes::Definition::overloads`].
    pub overload: usize,
    /// One for each input of the signature.
    pub inputs: Vec<Binding>,
}

/// What an input, or a root, gets its value from.
#[derive(Clone, Debug, PartialEq)]
pub enum Binding {
    /// Nothing given: the default of the signature.
    Default,
    /// A literal, already of the input's type.
    Literal(Literal),
    /// A parameter of the interface, by position; converted as [`Type::converts_to`] allows.
    Parameter(usize),
    /// An output of a node, by positions; converted as [`Type::converts_to`] allows.
    Node {
        /// Position in [`Graph::nodes`].
        node: usize,
        /// Position in the signature's outputs.
        output: usize,
    },
}

/// A root of a phenomenon.
#[derive(Clone, Debug)]
pub struct Root {
    /// What it is called for.
    pub kind: RootKind,
    /// A value of its kind's type; converted as [`Type::converts_to`] allows.
    pub color: Binding,
    /// A boolean, false for mental ray's miFALSE; [`Binding::Default`] means always true.
    pub ok: Binding,
}

/// A value that a phenomenon offers where it is a node.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Its doc.
    pub doc: String,
    /// Its type.
    pub value_type: Type,
    /// Where it comes from; converted as [`Type::converts_to`] allows.
    pub value: Binding,
}

impl Parameter {
    /// A parameter with that default and nothing else said of it.
    pub fn new(name: impl Into<String>, default: Literal) -> Self {
        Self {
            name: name.into(),
            doc: String::new(),
            value_type: default.value_type(),
            default,
            range: FINITE,
            soft_range: FINITE,
            unit: String::new(),
            labels: Vec::new(),
        }
    }
}

impl Graph {
    /// The root of a kind.
    pub fn root(&self, kind: RootKind) -> Option<&Root> {
        self.roots.iter().find(|root| root.kind == kind)
    }

    /// Position of the parameter called `name`.
    pub fn parameter(&self, name: &str) -> Option<usize> {
        self.parameters.iter().position(|parameter| parameter.name == name)
    }
}
