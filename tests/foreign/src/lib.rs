//! Nodes of another crate: one of each kind that the standard library has few of or none, in a group of
//! their own.

pub mod either;
pub mod loops;
pub mod posterize;
pub mod requests;
pub mod scopes;
pub mod twice;

use phenomenon_compiler::nodes::{Definition, Group, NodeLibrary};

/// The standard nodes, and those of this crate.
pub fn library() -> NodeLibrary {
    let mut library = NodeLibrary::standard();
    library.add_group(Group { name: "foreign", doc: "Nodes of another crate." });
    for definition in definitions() {
        library.add(definition);
    }
    library
}

fn definitions() -> Vec<Definition> {
    let mut all = vec![posterize::definition(), either::definition(), twice::definition()];
    all.extend(requests::definitions());
    all.extend(scopes::definitions());
    all.extend(loops::definitions());
    all
}
