//! The types a node of a file may have: those of the library, and the phenomena the file names.

use std::collections::HashMap;

use crate::nodes::{Definition, FINITE, Kind, ListForm, NodeLibrary, NodeType, Signature};
use crate::values::{Name, Type};

/// The types of nodes. Positions past those of the library are phenomena.
pub(super) struct NodeTypes<'l> {
    /// What every file may use.
    pub library: &'l NodeLibrary,
    known: usize,
    /// First those of [`NodeTypes::over_list`].
    phenomena: Vec<Definition>,
    over_lists: HashMap<NodeType, NodeType>,
    by_path: HashMap<Name, NodeType>,
}

impl<'l> NodeTypes<'l> {
    /// Those of the library alone.
    pub fn of(library: &'l NodeLibrary) -> Self {
        let known = library.iter().count();
        let mut types = Self {
            library,
            known,
            phenomena: Vec::new(),
            over_lists: HashMap::new(),
            by_path: HashMap::new(),
        };
        for (node_type, definition) in library.iter() {
            if let Some(over_list) = over_list(&definition.signature) {
                let next = NodeType(known + types.phenomena.len());
                types.over_lists.insert(node_type, next);
                types.phenomena.push(over_list);
            }
        }
        types
    }

    /// The type of a node that is given a list in place of its other inputs; none where it takes none.
    pub fn over_list(&self, node_type: NodeType) -> Option<NodeType> {
        self.over_lists.get(&node_type).copied()
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

    /// Whether a type is one of the library: no phenomenon, and none over a list in place of inputs.
    pub fn is_of_library(&self, node_type: NodeType) -> bool {
        node_type.0 < self.known
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

    /// The signatures of all, under each name once.
    pub fn signatures(&self) -> impl Iterator<Item = &Signature> {
        let library = self.library.iter().map(|(_, definition)| definition);
        let phenomena = &self.phenomena[self.over_lists.len()..];
        library.chain(phenomena).map(|definition| &definition.signature)
    }
}

/// A node over the list it takes in place of its inputs, the first aside, which tells which value.
fn over_list(signature: &Signature) -> Option<Definition> {
    let list = signature.or_list.clone()?;
    let index = signature.inputs.first()?.clone().within(FINITE);
    Some(Definition::without_body(Signature {
        inputs: vec![index, list],
        kind: Kind::List(ListForm::Element),
        generic: Type::COMPUTED.into(),
        or_list: None,
        ..signature.clone()
    }))
}
