//! Which nodes are tested.

use crate::nodes::{Definition, NodeLibrary, NodeType, Overload};

/// Nodes to be tested, with the library they stand in.
#[derive(Clone, Debug)]
pub struct Subjects {
    library: NodeLibrary,
    own: Vec<NodeType>,
}

impl Subjects {
    /// All nodes of a library.
    pub fn all(library: NodeLibrary) -> Self {
        let own = library.iter().map(|(node_type, _)| node_type).collect();
        Self { library, own }
    }

    /// The nodes that the standard library does not have.
    ///
    /// # Panics
    /// If there are none: tests of nothing pass.
    pub fn foreign(library: NodeLibrary) -> Self {
        let standard = NodeLibrary::standard();
        let names = library.iter().map(|(own, definition)| (own, &definition.signature.name));
        let foreign = names.filter(|(_, name)| standard.find(name).is_none());
        let own: Vec<_> = foreign.map(|(own, _)| own).collect();
        assert!(!own.is_empty(), "the library has the standard nodes only");
        Self { library, own }
    }

    /// The library.
    pub fn library(&self) -> &NodeLibrary {
        &self.library
    }

    /// The nodes.
    pub fn iter(&self) -> impl Iterator<Item = (NodeType, &Definition)> {
        self.own.iter().map(|&node_type| (node_type, self.library.definition(node_type)))
    }

    /// Every form of every node that has a body, for ways to give what is known before shading.
    pub(super) fn each_form(&self, mut visit: impl FnMut(&Definition, &Overload)) {
        for definition in self.iter().flat_map(|(_, definition)| definition.settled()) {
            for overload in &definition.overloads {
                visit(&definition, overload);
            }
        }
    }
}
