//! Nodes by a word.

use phenomenon_compiler::document::nearest;
use phenomenon_compiler::nodes::{NodeLibrary, Signature};

use crate::failure::Failure;

/// A node that was found.
pub struct Hit<'l> {
    /// The node.
    pub node: &'l Signature,
    /// Where the words are, the best place first.
    pub place: Place<'l>,
}

/// Where a word is, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place<'l> {
    /// It is the name.
    Name,
    /// It is a part of the name, or the group.
    PartOfName,
    /// It is the name of an input.
    Input(&'l str),
    /// It is the name of an output.
    Output(&'l str),
    /// It is in a doc.
    Doc,
}

/// The nodes that have all the words, the best first.
///
/// # Errors
/// There is none.
pub fn find<'l>(library: &'l NodeLibrary, words: &[String]) -> Result<Vec<Hit<'l>>, Failure> {
    let words: Vec<String> = words
        .iter()
        .flat_map(|words| words.split_whitespace())
        .map(|word| word.to_lowercase())
        .collect();
    let mut hits: Vec<Hit<'l>> = library
        .iter()
        .filter_map(|(_, definition)| {
            let node = &definition.signature;
            let places: Option<Vec<_>> = words.iter().map(|word| place(node, word)).collect();
            // All words must be there; the worst tells how well they fit.
            places?.into_iter().max().map(|place| Hit { node, place })
        })
        .collect();
    hits.sort_by_key(|hit| hit.place);
    if hits.is_empty() {
        let words = words.join(" ");
        let names = library.iter().map(|(_, definition)| definition.signature.name);
        let help = match nearest(&words, names) {
            Some(near) => near.help(),
            None => "`phenomenon nodes` lists all there are".into(),
        };
        return Err(Failure::new(format!("--search {words}: no node has this"), help));
    }
    Ok(hits)
}

fn place<'l>(node: &'l Signature, word: &str) -> Option<Place<'l>> {
    let has = |text: &str| text.to_lowercase().contains(word);
    if node.name == word {
        return Some(Place::Name);
    }
    if has(node.name) || has(node.group) {
        return Some(Place::PartOfName);
    }
    if let Some(input) = node.inputs.iter().find(|input| has(input.name)) {
        return Some(Place::Input(input.name));
    }
    if let Some(output) = node.outputs.iter().find(|output| has(output.name)) {
        return Some(Place::Output(output.name));
    }
    let docs = node.inputs.iter().map(|input| &input.doc);
    let mut docs = docs.chain(node.outputs.iter().map(|output| &output.doc));
    (has(&node.doc) || docs.any(|doc| has(doc))).then_some(Place::Doc)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(words: &str) -> Vec<&'static str> {
        let library = NodeLibrary::standard();
        let hits = find(&library, &[words.to_owned()]);
        hits.map_or(Vec::new(), |hits| hits.iter().map(|hit| hit.node.name).collect())
    }

    #[test]
    fn the_best_comes_first_and_all_words_count() {
        assert_eq!(names("mix").first(), Some(&"mix"));
        assert_eq!(names("MIX"), names("mix"));
        assert!(names("fresnel").iter().filter(|name| name.contains("fresnel")).count() > 1);
        assert!(names("weight").contains(&"mix"), "an input");
        assert!(names("mix weight").contains(&"mix") && !names("mix zzz").contains(&"mix"));
        assert!(names("zzzzzz").is_empty());
    }

    #[test]
    fn every_node_is_found_by_its_name() {
        for (_, definition) in NodeLibrary::standard().iter() {
            let name = definition.signature.name;
            assert_eq!(names(name).first(), Some(&name));
        }
    }
}
