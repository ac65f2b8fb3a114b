//! The types a node of a file may have: those of the library, and the phenomena the file names.

use std::collections::HashMap;

use crate::nodes::{Definition, NodeLibrary, NodeType, Signature};
use crate::values::Name;

/// The types of nodes. Positions past those of the library are phenomena.
pub(super) struct NodeTypes<'l> {
    /// What every file may use.
    pub library: &'l NodeLibrary,
    known: usize,
    phenomena: Vec<Definition>,
    by_path: HashMap<Name, NodeType>,
}

impl<'l> NodeTypes<'l> {
    /// Those of the library alone.
    pub fn of(library: &'l NodeLibrary) -> Self {
        let known = library.iter().count();
        Self { library, known, phenomena: Vec::new(), by_path: HashMap::new() }
    }

    /// Adds a phenomenon, which is named for its path; one of the same path is the same.
    pub fn add(&mut self, definition: Definition) -> NodeType {
        let next = NodeType(self.known + self.phenomena.len());
        let node_type = *self.by_path.entry(definition.signature.name.clone()).or_insert(next);
        if node_type == next {
            self.phenomena.push(definition);
        }
        node_type
    }

    /// Adds a phenomenon that stands in the file itself, by whatever name.
    pub fn add_inner(&mut self, definition: Definition) -> NodeType {
        self.phenomena.push(definition);
        NodeType(self.known + self.phenomena.len() - 1)
    }

    /// The definition of a type.
    pub fn definition(&self, node_type: NodeType) -> &Definition {
        match node_type.0.checked_sub(self.known) {
            Some(at) => &self.phenomena[at],
            None => self.library.definition(node_type),
        }
    }

    /// The signature of a type.
    pub fn signature(&self, node_type: NodeType) -> &Signature {
        &self.definition(node_type).signature
    }

    /// The signatures of all.
    pub fn signatures(&self) -> impl Iterator<Item = &Signature> {
        let library = self.library.iter().map(|(_, definition)| definition);
        library.chain(&self.phenomena).map(|definition| &definition.signature)
    }
}
