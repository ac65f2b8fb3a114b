//! The library of this crate's nodes.

use super::NodeLibrary;

impl NodeLibrary {
    /// The nodes of this crate.
    pub fn standard() -> Self {
        let mut library = Self::default();
        for definition in super::definitions() {
            library.add(definition);
        }
        library
    }
}
