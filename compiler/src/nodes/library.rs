//! The list of nodes as a value: another crate can extend it.

use std::collections::HashMap;

use crate::kernels::BodyForms;
use crate::values::Type;

use super::Signature;

/// A node for one type of its generic inputs, or the only form of a node without them.
#[derive(Clone, Debug)]
pub struct Overload {
    /// The type [`Type::Generic`] stands for.
    pub generic: Option<Type>,
    /// The body; none for requests and loops.
    pub code: Option<BodyForms>,
    /// Per input, the guard under which it is demanded.
    pub guards: Vec<Option<BodyForms>>,
}

/// All there is to know of a node type.
#[derive(Clone, Debug)]
pub struct Definition {
    /// What users and the checker see.
    pub signature: Signature,
    /// What engines run.
    pub overloads: Vec<Overload>,
}

/// Position of a node type in its [`NodeLibrary`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeType(pub usize);

/// The node types graphs can use.
#[derive(Clone, Debug, Default)]
pub struct NodeLibrary {
    definitions: Vec<Definition>,
    by_name: HashMap<&'static str, NodeType>,
}

impl NodeLibrary {
    /// Adds a node type, or replaces the one of the same name.
    ///
    /// # Panics
    /// If engines could not run it; [`Definition::check`] tells beforehand.
    pub fn add(&mut self, definition: Definition) {
        if let Err(error) = definition.check() {
            panic!("{error}");
        }
        let name = definition.signature.name;
        if let Some(&NodeType(at)) = self.by_name.get(name) {
            self.definitions[at] = definition;
        } else {
            self.by_name.insert(name, NodeType(self.definitions.len()));
            self.definitions.push(definition);
        }
    }

    /// The node type called `name`.
    pub fn find(&self, name: &str) -> Option<NodeType> {
        self.by_name.get(name).copied()
    }

    /// The definition of a node type of this library.
    pub fn definition(&self, node_type: NodeType) -> &Definition {
        &self.definitions[node_type.0]
    }

    /// The signature of a node type of this library.
    pub fn signature(&self, node_type: NodeType) -> &Signature {
        &self.definitions[node_type.0].signature
    }

    /// Every node type with its definition, in the order of the list.
    pub fn iter(&self) -> impl Iterator<Item = (NodeType, &Definition)> {
        self.definitions.iter().enumerate().map(|(at, definition)| (NodeType(at), definition))
    }
}

/// Joins the lines of a doc comment.
pub fn paragraph(lines: &[&str]) -> String {
    let lines: Vec<&str> =
        lines.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    lines.join("\n")
}
