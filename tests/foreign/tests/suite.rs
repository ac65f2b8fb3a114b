//! The nodes of this crate keep to all that the nodes of the compiler keep to.

use phenomenon_compiler::test_nodes;
use phenomenon_compiler::testing::Subjects;
use phenomenon_foreign_nodes::library;

test_nodes!(foreign_nodes: Subjects::foreign(library()));

#[test]
fn the_group_stands_after_the_standard_ones_with_its_nodes() {
    let library = library();
    let group = library.groups().last().expect("a group");
    assert_eq!((group.name, group.doc), ("foreign", "Nodes of another crate."));
    let signatures = library.iter().map(|(_, definition)| &definition.signature);
    let own = signatures.filter(|signature| signature.group == group.name);
    assert_eq!(own.count(), Subjects::foreign(library.clone()).iter().count());
}
