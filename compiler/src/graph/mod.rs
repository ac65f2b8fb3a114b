//! A checked graph: names resolved, types settled, every input bound. What [`crate::check`] makes
//! and the engines start from.

pub(crate) mod bind;
pub(crate) mod parts;
mod requirements;
mod with_root;

use crate::nodes::{FINITE, NodeType};
use crate::values::{Literal, Type};
use std::ops::RangeInclusive;

pub use bind::BindError;
pub use requirements::Requirements;
pub use with_root::WithRootError;

/// A phenomenon without findings of severity error.
#[derive(Clone, Debug, Default)]
pub struct Graph {
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
    /// Nodes; connections between them form no cycle.
    pub nodes: Vec<Node>,
    /// Roots, at most one for each shader type.
    pub roots: Vec<Root>,
    /// Inputs that are never evaluated, as literals and the ranges of parameters prove: positions of a
    /// node and of one of its inputs, ascending. For those who look at the graph; engines find out by
    /// themselves.
    pub ruled_out: Vec<(usize, usize)>,
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

/// A node of a graph.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name; inside nested phenomena joined by `/`.
    pub name: String,
    /// Its type in the [`crate::nodes::NodeLibrary`] the graph was checked with.
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

/// What a root is called for: the shader types of mental ray. Engines run a root of any type; which
/// of them a renderer calls is its own matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RootKind {
    /// A visible ray hit the surface; yields the colour it sees.
    Material,
    /// A shadow ray hit the surface; yields the colour by which light is multiplied.
    Shadow,
    /// A ray left the scene; yields the colour it sees.
    Environment,
    /// A ray passed through a volume; changes the colour it saw.
    Volume,
    /// A light is asked what it sends to a point.
    Light,
    /// A ray leaves the camera.
    Lens,
    /// Another shader asks for a texture.
    Texture,
    /// A vertex is displaced along its normal; yields a distance.
    Displacement,
    /// The picture is finished, pixel by pixel.
    Output,
    /// A photon hit the surface; changes its energy.
    Photon,
    /// A contour line is drawn.
    Contour,
    /// A light map is written.
    Lightmap,
    /// Geometry is made before rendering.
    Geometry,
    /// A state is set up or taken down.
    State,
}

impl RootKind {
    /// Every kind.
    pub const ALL: [RootKind; 14] = [
        RootKind::Material,
        RootKind::Shadow,
        RootKind::Environment,
        RootKind::Volume,
        RootKind::Light,
        RootKind::Lens,
        RootKind::Texture,
        RootKind::Displacement,
        RootKind::Output,
        RootKind::Photon,
        RootKind::Contour,
        RootKind::Lightmap,
        RootKind::Geometry,
        RootKind::State,
    ];

    /// Name in graph files.
    pub fn name(self) -> &'static str {
        match self {
            RootKind::Material => "material",
            RootKind::Shadow => "shadow",
            RootKind::Environment => "environment",
            RootKind::Volume => "volume",
            RootKind::Light => "light",
            RootKind::Lens => "lens",
            RootKind::Texture => "texture",
            RootKind::Displacement => "displacement",
            RootKind::Output => "output",
            RootKind::Photon => "photon",
            RootKind::Contour => "contour",
            RootKind::Lightmap => "lightmap",
            RootKind::Geometry => "geometry",
            RootKind::State => "state",
        }
    }

    /// The type of its value: a displacement is a scalar, all others are colours.
    pub fn value_type(self) -> Type {
        match self {
            RootKind::Displacement => Type::Scalar,
            _ => Type::Color,
        }
    }
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
