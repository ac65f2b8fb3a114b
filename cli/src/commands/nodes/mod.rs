//! `phenomenon nodes`.

mod human;
mod json;
mod search;

use clap::Args;
use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::nodes::{GROUPS, NodeLibrary, Signature};

use crate::arguments::Format;
use crate::failure::{Failure, Outcome};
use crate::terminal;

/// List the nodes graphs can use, or tell all about one.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A node or a group; without it all are listed
    name: Option<String>,

    /// List the nodes that have these words in their name, inputs, outputs or docs, or that other
    /// programs call so
    #[arg(long, value_name = "WORD", conflicts_with = "name", num_args = 1..)]
    search: Vec<String>,

    /// How to print
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  phenomenon nodes
  phenomenon nodes mix
  phenomenon nodes rays
  phenomenon nodes --search lerp
  phenomenon nodes --search reflection colour
  phenomenon nodes mix --format json";

/// What a name asks for.
enum Subject<'l> {
    Node(&'l Signature),
    Groups(Vec<Group<'l>>),
}

/// A group with its nodes, in the order of the list.
struct Group<'l> {
    name: &'static str,
    doc: &'static str,
    nodes: Vec<&'l Signature>,
}

/// Runs the command.
///
/// # Errors
/// An unknown name, or standard output that cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let library = NodeLibrary::standard();
    if !arguments.search.is_empty() {
        let found = search::find(&library, &arguments.search)?;
        match arguments.format {
            Format::Human => terminal::print(&human::found(&found)),
            Format::Json => terminal::print_exactly(&json::found(&found)),
        }?;
        return Ok(Outcome::Fine);
    }
    let subject = subject(&library, arguments.name.as_deref())?;
    match (&subject, arguments.format) {
        (Subject::Node(node), Format::Human) => terminal::print(&human::node(node)),
        (Subject::Node(node), Format::Json) => terminal::print_exactly(&json::node(node)),
        (Subject::Groups(groups), Format::Human) => terminal::print(&human::groups(groups)),
        (Subject::Groups(groups), Format::Json) => terminal::print_exactly(&json::groups(groups)),
    }?;
    Ok(Outcome::Fine)
}

fn subject<'l>(library: &'l NodeLibrary, name: Option<&str>) -> Result<Subject<'l>, Failure> {
    let Some(name) = name else {
        return Ok(Subject::Groups(grouped(library, None)));
    };
    if let Some(node) = library.find(name) {
        return Ok(Subject::Node(library.signature(node)));
    }
    if GROUPS.iter().any(|(group, _)| *group == name) {
        return Ok(Subject::Groups(grouped(library, Some(name))));
    }
    let names = library.iter().map(|(_, definition)| definition.signature.name);
    let help = match nearest(name, names.chain(GROUPS.iter().map(|(group, _)| *group))) {
        Some(near) => near.help(),
        None => "`phenomenon nodes` lists all there are".into(),
    };
    Err(Failure::new(format!("there is no node or group `{name}`"), help))
}

fn grouped<'l>(library: &'l NodeLibrary, only: Option<&str>) -> Vec<Group<'l>> {
    let of_group = |group: &str| {
        let signatures = library.iter().map(|(_, definition)| &definition.signature);
        signatures.filter(|signature| signature.group == group).collect()
    };
    GROUPS
        .iter()
        .filter(|(name, _)| only.is_none_or(|only| only == *name))
        .map(|(name, doc)| Group { name, doc: doc.trim(), nodes: of_group(name) })
        .collect()
}

/// The first sentence of a doc, on one line.
fn first_sentence(doc: &str) -> String {
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
