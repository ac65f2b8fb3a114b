//! The node types of all inputs.

use std::sync::LazyLock;

use phenomenon_compiler::nodes::NodeLibrary;

pub static LIBRARY: LazyLock<NodeLibrary> = LazyLock::new(NodeLibrary::standard);
