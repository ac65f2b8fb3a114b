//! The suite over the whole list of nodes, and over those that only tests have.

use super::NodeLibrary;
use crate::testing::{Subjects, forms};

/// The nodes of the list, and one with inputs known before shading.
fn library() -> NodeLibrary {
    let mut library = NodeLibrary::standard();
    library.add(super::fixed_inputs::powers::definition());
    library
}

crate::test_nodes!(all_nodes: Subjects::all(library()));

#[test]
fn many_nodes_are_per_component() {
    let all = Subjects::all(library());
    let tried = forms::nodes_per_component_take_each_alone_and_keep_the_alpha_of_the_first(&all);
    assert!(tried >= 3 * 20, "{tried} forms are per component");
}
