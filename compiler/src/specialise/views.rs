//! One look at all nodes: those of the graph, those its inputs imply by their defaults, and the
//! root.

use std::borrow::Cow;

use rustc_hash::FxHashMap;

use crate::graph::{Binding, Graph, Root};
use crate::nodes::{DefaultValue, Definition, Kind, NodeLibrary, Overload, Signature};
use crate::state::Field;
use crate::values::{Literal, Type};

use super::{SpecialiseError, internal};

/// What an input gets its value from, defaults resolved.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Resolved {
    /// A constant of the input's type.
    Literal(Literal),
    /// A parameter of the interface.
    Parameter(usize),
    /// A field of the state.
    State(Field),
    /// An output of a node.
    Node {
        /// Which.
        view: usize,
        /// Position in its outputs.
        output: usize,
    },
}

struct View<'a> {
    name: Cow<'a, str>,
    definition: &'a Definition,
    overload: usize,
    bindings: Cow<'a, [Binding]>,
}

/// All nodes; the graph's first, in its order, the root last.
pub(super) struct Views<'a> {
    views: Vec<View<'a>>,
    implied: FxHashMap<&'static str, usize>,
}

impl<'a> Views<'a> {
    /// The nodes of `graph` for `root`.
    pub fn new(graph: &'a Graph, root: &Root) -> Result<Self, SpecialiseError> {
        let library = &graph.library;
        let mut views = Vec::with_capacity(graph.nodes.len() + 1);
        for node in &graph.nodes {
            let definition = library.definition(node.node_type);
            let fits = node.inputs.len() == definition.signature.inputs.len()
                && node.overload < definition.overloads.len();
            if !fits {
                return Err(inconsistent(&node.name, "its inputs are not those of its type"));
            }
            views.push(View {
                name: Cow::Borrowed(&node.name),
                definition,
                overload: node.overload,
                bindings: Cow::Borrowed(&node.inputs),
            });
        }
        let mut all = Self { views, implied: FxHashMap::default() };
        let mut next = 0;
        while next < all.views.len() {
            all.imply(next, library)?;
            next += 1;
        }
        all.views.push(View {
            name: Cow::Owned(format!("{}.{}", graph.name, root.kind.name())),
            definition: internal::root_definition(),
            overload: 0,
            bindings: Cow::Owned(vec![root.ok.clone(), root.color.clone()]),
        });
        Ok(all)
    }

    /// Adds the nodes that defaults of `view` imply, each type once.
    fn imply(&mut self, view: usize, library: &'a NodeLibrary) -> Result<(), SpecialiseError> {
        let View { definition, bindings, name, .. } = &self.views[view];
        let mut missing = Vec::new();
        for (input, binding) in definition.signature.inputs.iter().zip(bindings.iter()) {
            match (&input.default, binding) {
                (DefaultValue::Node(implied), Binding::Default)
                    if !self.implied.contains_key(implied) =>
                {
                    missing.push(*implied);
                }
                (DefaultValue::Required, Binding::Default) => {
                    return Err(inconsistent(name, &format!("input `{}` is missing", input.name)));
                }
                _ => {}
            }
        }
        for implied in missing {
            let Some(node_type) = library.find(implied) else {
                return Err(inconsistent(
                    implied,
                    "an input implies this node type, which is unknown",
                ));
            };
            let definition = library.definition(node_type);
            self.implied.insert(implied, self.views.len());
            self.views.push(View {
                name: Cow::Owned(format!("({implied})")),
                definition,
                overload: 0,
                bindings: vec![Binding::Default; definition.signature.inputs.len()].into(),
            });
        }
        Ok(())
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.views.len()
    }

    /// The root.
    pub fn root(&self) -> usize {
        self.views.len() - 1
    }

    /// The node's name.
    pub fn name(&self, view: usize) -> &str {
        &self.views[view].name
    }

    /// The node's signature.
    pub fn signature(&self, view: usize) -> &'a Signature {
        &self.views[view].definition.signature
    }

    /// The form of the node that is used.
    pub fn overload(&self, view: usize) -> &'a Overload {
        &self.views[view].definition.overloads[self.views[view].overload]
    }

    /// The inputs known before shading, each with its word.
    pub fn fixed_words(&self, view: usize) -> Vec<(usize, usize)> {
        self.views[view].definition.fixed_words(self.overload(view)).collect()
    }

    /// Number of inputs.
    pub fn inputs(&self, view: usize) -> usize {
        self.views[view].bindings.len()
    }

    /// Type of an input, generic ones settled.
    pub fn input_type(&self, view: usize, input: usize) -> Type {
        self.settled(view, self.signature(view).inputs[input].value_type)
    }

    /// Type of an output, generic ones settled.
    pub fn output_type(&self, view: usize, output: usize) -> Type {
        self.settled(view, self.signature(view).outputs[output].value_type)
    }

    fn settled(&self, view: usize, value_type: Type) -> Type {
        match (value_type, self.overload(view).generic) {
            (Type::Generic, Some(generic)) => generic,
            _ => value_type,
        }
    }

    /// First word of an output: a body writes them in order, a request leaves them where they are
    /// in the answer.
    pub fn output_offset(&self, view: usize, output: usize) -> Result<usize, SpecialiseError> {
        let signature = self.signature(view);
        let Kind::Request(effect) = signature.kind else {
            return Ok((0..output).map(|before| self.output_type(view, before).width()).sum());
        };
        let name = &signature.outputs[output].name;
        effect.answer_offset(name).ok_or_else(|| {
            let problem = format!("`{}` does not answer `{name}`", effect.name());
            inconsistent(self.name(view), &problem)
        })
    }

    /// Words of all inputs.
    pub fn input_words(&self, view: usize) -> usize {
        (0..self.inputs(view)).map(|input| self.input_type(view, input).width()).sum()
    }

    /// The node an input gets its value from, if it gets it from one.
    pub fn source(&self, view: usize, input: usize) -> Option<usize> {
        match &self.views[view].bindings[input] {
            Binding::Node { node, .. } => Some(*node),
            Binding::Default => match &self.signature(view).inputs[input].default {
                DefaultValue::Node(implied) => Some(self.implied[implied]),
                _ => None,
            },
            Binding::Literal(_) | Binding::Parameter(_) => None,
        }
    }

    /// Whether nothing is given for an input.
    pub fn is_default(&self, view: usize, input: usize) -> bool {
        self.views[view].bindings[input] == Binding::Default
    }

    /// What an input gets its value from.
    pub fn resolve(&self, view: usize, input: usize) -> Resolved {
        match &self.views[view].bindings[input] {
            Binding::Literal(literal) => Resolved::Literal(literal.clone()),
            Binding::Parameter(parameter) => Resolved::Parameter(*parameter),
            Binding::Node { node, output } => Resolved::Node { view: *node, output: *output },
            Binding::Default => match &self.signature(view).inputs[input].default {
                DefaultValue::Literal(literal) => {
                    let to = self.input_type(view, input);
                    Resolved::Literal(literal.as_default(to).unwrap_or_else(|| literal.clone()))
                }
                DefaultValue::State(field) => Resolved::State(*field),
                DefaultValue::Node(implied) => {
                    Resolved::Node { view: self.implied[implied], output: 0 }
                }
                // Refused in `new`.
                DefaultValue::Required => Resolved::Literal(Literal::Lights(Vec::new())),
            },
        }
    }
}

/// The error of a graph that was not checked with this library.
pub(super) fn inconsistent(node: &str, problem: &str) -> SpecialiseError {
    SpecialiseError::Inconsistent { node: node.to_owned(), problem: problem.to_owned() }
}
