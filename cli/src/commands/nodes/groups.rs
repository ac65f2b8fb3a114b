//! Nodes by their groups.

use phenomenon_compiler::nodes::{NodeLibrary, Signature};

/// A group with its nodes, in the order of the list.
pub struct Group<'l> {
    /// Its name.
    pub name: &'static str,
    /// What it holds.
    pub doc: &'static str,
    /// Its nodes.
    pub nodes: Vec<&'l Signature>,
}

/// The groups of the library, or the one called `only`.
pub fn grouped<'l>(library: &'l NodeLibrary, only: Option<&str>) -> Vec<Group<'l>> {
    let of_group = |group: &str| {
        let signatures = library.iter().map(|(_, definition)| &definition.signature);
        signatures.filter(|signature| signature.group == group).collect()
    };
    let groups = library.groups().iter();
    let wanted = groups.filter(|group| only.is_none_or(|only| only == group.name));
    wanted
        .map(|group| Group { name: group.name, doc: group.doc, nodes: of_group(group.name) })
        .collect()
}

/// The first sentence of a doc, on one line.
pub fn first_sentence(doc: &str) -> String {
    let line = doc.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.find(". ") {
        Some(at) => line[..=at].to_owned(),
        None => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_node_of_the_library_is_listed_once() {
        let library = NodeLibrary::standard();
        let listed: usize = grouped(&library, None).iter().map(|group| group.nodes.len()).sum();
        assert_eq!(listed, library.iter().count());
    }

    #[test]
    fn a_first_sentence_ends_at_its_stop() {
        assert_eq!(first_sentence("One two.\nThree."), "One two.");
        assert_eq!(first_sentence("Scale 0.5 up\nor down"), "Scale 0.5 up or down");
    }
}
