//! The library of this crate's nodes.

use super::{GROUPS, Group, NodeLibrary};

impl NodeLibrary {
    /// The nodes of this crate, in their groups.
    pub fn standard() -> Self {
        let mut library = Self::default();
        for &(name, doc) in GROUPS {
            library.add_group(Group { name, doc: doc.trim() });
        }
        for definition in super::definitions() {
            library.add(definition);
        }
        library
    }
}
