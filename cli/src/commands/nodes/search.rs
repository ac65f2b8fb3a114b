//! Nodes by a word, which may be one of other programs.

use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::diagnostics::peers::{self, Entry};
use phenomenon_compiler::diagnostics::synonyms::{self, Synonym};
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
    /// It is what others call the node, and nothing else.
    Exact,
    /// It is the name of a node of ours that others use for this one.
    Also,
    /// It is what others call the node, among other things.
    Called,
    /// It is the name of a node of others, which this one stands for, alone or with others.
    Peer,
    /// It is a part of what others call the node.
    PartOfCalled,
    /// It is a part of the name, or the group.
    PartOfName,
    /// It is the name of an input.
    Input(&'l str),
    /// It is the name of an output.
    Output(&'l str),
    /// It is in a doc.
    Doc,
}

/// What was found.
pub struct Found<'l> {
    /// The nodes, the best first.
    pub hits: Vec<Hit<'l>>,
    /// What to mind, or to do instead; may be empty.
    pub advice: &'static str,
    /// What there is for the nodes of others that are called so, where the nodes do not tell.
    pub peers: Vec<Entry>,
}

/// The nodes that have all the words, or that others call so, the best first.
///
/// # Errors
/// There is none: with what to do instead.
pub fn find<'l>(library: &'l NodeLibrary, words: &[String]) -> Result<Found<'l>, Failure> {
    let query = Query::new(words);
    let nodes = library.iter().map(|(_, definition)| &definition.signature);
    let mut hits: Vec<Hit<'l>> =
        nodes.filter_map(|node| query.place(node).map(|place| Hit { node, place })).collect();
    hits.sort_by_key(|hit| hit.place);
    let Some(first) = hits.first() else {
        return Err(query.without_hits(library));
    };
    let advice = query.advice();
    let is_told = |entry: &Entry| entry.what == format!("`{}`", first.node.name);
    let mut peers = query.peers;
    peers.retain(|entry| !is_told(entry));
    Ok(Found { hits, advice, peers })
}

/// What is looked for.
struct Query {
    /// All of it, in lower case.
    text: String,
    /// What others mean by all of it.
    meant: Option<Synonym>,
    /// Its words, each with what others mean by it.
    words: Vec<(String, Option<Synonym>)>,
    /// The nodes of others that are called so.
    peers: Vec<Entry>,
}

impl Query {
    fn new(words: &[String]) -> Self {
        let text = words.join(" ").to_lowercase();
        let words = text.split_whitespace();
        let words = words.map(|word| (word.to_owned(), synonyms::node(word))).collect();
        Self { meant: synonyms::node(&text), peers: peers::called(&text), words, text }
    }

    fn place<'l>(&self, node: &'l Signature) -> Option<Place<'l>> {
        if let Some(place) = means(&self.text, &self.meant, node) {
            return Some(place);
        }
        if self.peers.iter().flat_map(Entry::named).any(|name| *name == *node.name) {
            return Some(Place::Peer);
        }
        // All words must be there; the worst tells how well they fit.
        let places: Option<Vec<_>> =
            self.words.iter().map(|(word, meant)| place(node, word, meant)).collect();
        places?.into_iter().max()
    }

    /// What the tables say to whoever types this.
    fn advice(&self) -> &'static str {
        let all = std::iter::once(&self.meant).chain(self.words.iter().map(|(_, it)| it));
        all.flatten().map(|it| it.advice).find(|advice| !advice.is_empty()).unwrap_or("")
    }

    fn without_hits(&self, library: &NodeLibrary) -> Failure {
        let names = library.iter().map(|(_, definition)| &*definition.signature.name);
        let answers: Vec<String> = self.peers.iter().map(Entry::answer).collect();
        let help = match (self.advice(), answers.as_slice(), nearest(&self.text, names)) {
            ("", [], Some(near)) => near.help(),
            ("", [], None) => "`phenomenon nodes` lists all there are".into(),
            ("", answers, _) => answers.join("; "),
            (advice, ..) => advice.to_owned(),
        };
        Failure::new(format!("--search {}: no node has this", self.text), help)
    }
}

/// How a name means a node, if it does.
fn means<'l>(text: &str, meant: &Option<Synonym>, node: &Signature) -> Option<Place<'l>> {
    if node.name == text {
        return Some(Place::Name);
    }
    if synonyms::also(text).any(|other| other == &*node.name) {
        return Some(Place::Also);
    }
    let synonym = meant.as_ref().filter(|synonym| synonym.ours.contains(&&*node.name))?;
    Some(if synonym.exact { Place::Exact } else { Place::Called })
}

fn place<'l>(node: &'l Signature, word: &str, meant: &Option<Synonym>) -> Option<Place<'l>> {
    if let Some(place) = means(word, meant, node) {
        return Some(place);
    }
    let has = |text: &str| text.to_lowercase().contains(word);
    // A letter or two are a part of almost any word.
    if word.len() >= 3 && synonyms::of_node(&node.name).any(has) {
        return Some(Place::PartOfCalled);
    }
    if has(&node.name) || has(node.group) {
        return Some(Place::PartOfName);
    }
    if let Some(input) = node.inputs.iter().find(|input| has(&input.name)) {
        return Some(Place::Input(&input.name));
    }
    if let Some(output) = node.outputs.iter().find(|output| has(&output.name)) {
        return Some(Place::Output(&output.name));
    }
    let docs = node.inputs.iter().map(|input| &input.doc);
    let mut docs = docs.chain(node.outputs.iter().map(|output| &output.doc));
    (has(&node.doc) || docs.any(|doc| has(doc))).then_some(Place::Doc)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(words: &str) -> Vec<String> {
        let library = NodeLibrary::standard();
        let hits = find(&library, &[words.to_owned()]);
        hits.map_or(Vec::new(), |found| {
            found.hits.iter().map(|hit| hit.node.name.to_string()).collect()
        })
    }

    #[test]
    fn the_best_comes_first_and_all_words_count() {
        assert_eq!(names("mix")[0], "mix");
        assert_eq!(names("MIX"), names("mix"));
        assert!(names("fresnel").iter().filter(|name| name.contains("fresnel")).count() > 1);
        let has_mix = |words: &str| names(words).iter().any(|name| name == "mix");
        assert!(has_mix("weight"), "an input");
        assert!(has_mix("mix weight") && !has_mix("mix zzz"));
        assert!(names("zzzzzz").is_empty());
        for (theirs, ours) in
            [("lerp", "mix"), ("pow", "power"), ("Max", "maximum"), ("lerp weight", "mix")]
        {
            assert_eq!(names(theirs)[0], ours, "{theirs}");
        }
    }

    #[test]
    fn every_node_is_found_by_its_name() {
        for (_, definition) in NodeLibrary::standard().iter() {
            let name = &definition.signature.name;
            assert_eq!(names(name)[0], **name);
        }
    }

    /// What people who come from other programs type first, with what they mean by it: nodes, any of
    /// which is among the first three, or `!`, for which there is advice.
    #[test]
    fn what_is_typed_first_leads_to_what_is_meant() {
        let library = NodeLibrary::standard();
        let mut lost = Vec::new();
        let lines = include_str!("typed.txt").lines().filter(|line| !line.starts_with("# "));
        for line in lines.clone() {
            let (typed, meant) = line.split_once(" | ").expect("what is typed, and what is meant");
            let words = [typed.to_owned()];
            let first: Vec<String> = find(&library, &words).map_or(Vec::new(), |found| {
                found.hits.iter().take(3).map(|hit| hit.node.name.to_string()).collect()
            });
            let leads = match meant {
                "!" => !Query::new(&words).advice().is_empty(),
                _ => meant.split_whitespace().any(|name| first.iter().any(|it| it == name)),
            };
            if !leads {
                lost.push(format!("{typed}: {first:?} is not {meant}"));
            }
        }
        assert!(lines.count() >= 450);
        assert!(lost.is_empty(), "{}", lost.join("\n"));
    }

    /// Every name of the lists: one of the nodes that stand for it comes first, or it is said what to do instead.
    #[test]
    fn every_name_of_others_is_found_or_answered() {
        let library = NodeLibrary::standard();
        let mut lost = Vec::new();
        for entry in peers::LISTS.iter().flat_map(|list| list.entries()) {
            let is_answered = match find(&library, &[entry.name.replace(':', " ")]) {
                Ok(found) => {
                    let first = &*found.hits[0].node.name;
                    entry.named().any(|name| name == first)
                        || found.peers.iter().any(|told| told.name == entry.name)
                }
                // What the tables advise, or what the list says.
                Err(failure) => !failure.help().contains("lists all there are"),
            };
            if !is_answered {
                lost.push(format!("{} {}", entry.of, entry.name));
            }
        }
        assert!(lost.is_empty(), "{}", lost.join("\n"));
    }

    #[test]
    fn names_of_ours_that_others_use_otherwise_lead_there_too() {
        for (typed, meant) in [("gain", "scale"), ("bias", "add"), ("wrap", "modulo")] {
            let found = names(typed);
            assert_eq!((&*found[0], &*found[1]), (typed, meant));
        }
    }
}
