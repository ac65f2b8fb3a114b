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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    /// Answer a request.
    Request(Effect),
    /// Tell what a loop runs over.
    Turns(Iterated),
    /// Know a field of the state.
    Field(Field),
}

/// A node, as it is called in its graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// Its name, in parentheses where a default implies it; of the nodes an expression became, that of the expression.
    pub name: String,
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
    /// No point asks it: inputs on every way to it are never asked for, as was decided while the graph was
    /// specialised.
    Folded(Vec<Reason>),
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

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.expression {
            Some(text) => write!(f, "the expression `{}`", shortened(text)),
            None => write!(f, "{} `{}`", self.node_type, shortened(&self.name)),
        }
    }
}

/// As a sentence: mix `inner` never asks for its `a`: `weight` is the parameter `opacity`, which is 1.
impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} never asks for its `{}`", self.node, self.input)?;
        for (at, cause) in self.causes.iter().enumerate() {
            write!(f, "{} {cause}", if at == 0 { ":" } else { "," })?;
        }
        Ok(())
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Cause { input, value, origin } = self;
        match origin {
            Origin::Given => write!(f, "`{input}` is given as {value}"),
            Origin::Default => write!(f, "`{input}` is {value} by default"),
            Origin::Parameter(parameter) => {
                write!(f, "`{input}` is the parameter `{}`, which is {value}", shortened(parameter))
            }
            Origin::RayType => write!(f, "the ray is of type {value}"),
            Origin::Computed { node, from, ray_type } => {
                write!(f, "`{input}` is {value}, which {node} makes")?;
                let parameters = from.iter().map(|(name, value)| {
                    format!("the parameter `{}`, which is {value}", shortened(name))
                });
                let ray_type = ray_type.map(|it| format!("the ray type, which is {}", it.name()));
                let mut sources = parameters.chain(ray_type);
                if let Some(first) = sources.next() {
                    write!(f, " of {first}")?;
                }
                sources.try_for_each(|source| write!(f, ", and {source}"))
            }
        }
    }
}
