//! The data of an account, and its words.

use std::fmt;

use crate::diagnostics::shortened;
use crate::effects::{Effect, NamedLights};
use crate::graph::RootKind;
use crate::state::{Field, Iterated, RayType};
use crate::values::Texture;

/// What one root asks of the renderer for one ray type, and what of its graph it never asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Account {
    /// The root.
    pub root: RootKind,
    /// The ray type; none where the root is the same for all.
    pub ray_type: Option<RayType>,
    /// Its parts: one for each node that asks or loops, and one for each field of the state.
    pub parts: Vec<Part>,
}

/// A node that, by its declaration, has the renderer do something.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What.
    pub needed: Needed,
    /// The node.
    pub node: Named,
    /// The texture it is about, if it is about one.
    pub texture: Option<Texture>,
    /// Whether the texture is read by footprints.
    pub filtered: bool,
    /// The lights it loops over, if it loops over some.
    pub lights: Option<NamedLights>,
    /// How many samples it loops over, where that is known before shading.
    pub samples: Option<i32>,
    /// What became of it.
    pub fate: Fate,
}

/// What a node has the renderer do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Needed {
    /// Answer a request.
    Request(Effect),
    /// Tell what a loop runs over.
    Turns(Iterated),
    /// Know a field of the state.
    Field(Field),
}

/// Most inputs that are told of where several lead to a node and are never evaluated.
pub const TOLD_REASONS: usize = 2;

/// A node, as it is called in its graph.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Named {
    /// Its name; of the nodes an expression became, that of the expression.
    pub name: String,
    /// The type of the node that a default of this one implies, where that is meant.
    pub implied: Option<String>,
    /// The text of that expression.
    pub expression: Option<String>,
    /// Its type.
    pub node_type: String,
}

/// What became of a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Fate {
    /// Some point may ask it.
    Asked,
    /// No point asks it: inputs on every way to it are never evaluated, as was decided while the graph was
    /// specialised. Most that are told of are [`TOLD_REASONS`].
    Folded {
        /// Why, for the first of these inputs.
        reasons: Vec<Reason>,
        /// Whether there are more.
        more: bool,
    },
    /// It is asked, and has nothing to ask about: no texture is given.
    AboutNothing,
    /// Nothing connects it to the root.
    Unconnected,
}

/// Why an input is never asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// The node.
    pub node: Named,
    /// The input.
    pub input: String,
    /// What the node decides it by.
    pub causes: Vec<Cause>,
}

/// An input by which a node decides which others to ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Its name.
    pub input: String,
    /// Its value, as it is written in a file.
    pub value: String,
    /// Where the value comes from.
    pub origin: Origin,
}

/// Where a value comes from that is known before shading.
#[derive(Clone, Debug, PartialEq)]
pub enum Origin {
    /// The node is given it.
    Given,
    /// Nothing is given.
    Default,
    /// A parameter of the interface.
    Parameter(String),
    /// The ray type for which the root is specialised.
    RayType,
    /// A node computes it, from these parameters with their values and perhaps the ray type.
    Computed {
        /// The node.
        node: Named,
        /// Names and values of the parameters.
        from: Vec<(String, String)>,
        /// Whether the ray type matters.
        ray_type: Option<RayType>,
    },
}

impl Reason {
    /// Whether it holds for one type of ray, and another might be told for others.
    pub fn depends_on_ray_type(&self) -> bool {
        self.causes.iter().any(|cause| {
            matches!(cause.origin, Origin::RayType | Origin::Computed { ray_type: Some(_), .. })
        })
    }

    /// Why, the fact first: `opacity` = 1: `opacity < 1` is false, so select `let_through` never evaluates `if_true`.
    /// `place` is put behind the node.
    pub fn told(&self, place: &str) -> String {
        let mut settings: Vec<String> = Vec::new();
        for setting in self.causes.iter().flat_map(Cause::settings) {
            if !settings.contains(&setting) {
                settings.push(setting);
            }
        }
        let mut words = settings.join(", ");
        let facts: Vec<String> = self.causes.iter().filter_map(Cause::fact).collect();
        for (text, before) in [(facts.join(" and "), ": "), (self.consequence(place), ", so ")] {
            if !words.is_empty() && !text.is_empty() {
                words += before;
            }
            words += &text;
        }
        words
    }

    fn consequence(&self, place: &str) -> String {
        format!("{}{place} never evaluates `{}`", self.node, self.input)
    }
}

impl Cause {
    /// What decides it from outside: values of parameters, and the type of the ray.
    fn settings(&self) -> Vec<String> {
        let set = |name: &str, value: &str| format!("`{}` = {value}", shortened(name));
        match &self.origin {
            Origin::Given | Origin::Default => Vec::new(),
            Origin::Parameter(parameter) => vec![set(parameter, &self.value)],
            Origin::RayType => vec![format!("for rays of type {}", self.value)],
            Origin::Computed { from, ray_type, .. } => {
                let of_rays = ray_type.map(|it| format!("for rays of type {}", it.name()));
                from.iter().map(|(name, value)| set(name, value)).chain(of_rays).collect()
            }
        }
    }

    /// What follows for the input.
    fn fact(&self) -> Option<String> {
        let Cause { input, value, origin } = self;
        match origin {
            Origin::Given => Some(format!("`{input}` is given as {value}")),
            Origin::Default => Some(format!("`{input}` is {value} by default")),
            Origin::Parameter(parameter) if parameter == input => None,
            Origin::Parameter(_) => Some(format!("`{input}` is {value}")),
            Origin::RayType => None,
            Origin::Computed { node, .. } => Some(match &node.expression {
                Some(text) => format!("`{}` is {value}", shortened(text)),
                None => format!("`{input}`, which {node} computes, is {value}"),
            }),
        }
    }
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.expression {
            Some(text) => write!(f, "the expression `{}`", shortened(text))?,
            None => write!(f, "{} `{}`", self.node_type, shortened(&self.name))?,
        }
        match &self.implied {
            Some(node_type) => write!(f, ", by its default {node_type},"),
            None => Ok(()),
        }
    }
}
