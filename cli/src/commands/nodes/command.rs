//! The arguments of the command, and what it does.

use std::path::Path;

use clap::Args;
use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::nodes::{NodeLibrary, Signature};

use super::groups::{Group, grouped};
use super::{human, json, search};
use crate::arguments::Format;
use crate::failure::{Failure, Outcome};
use crate::graphs;
use crate::terminal;

/// List the nodes graphs can use, or tell all about one.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A node or a group, or a graph file as the node it is; without it all are listed
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
  phenomenon nodes graphs/painted/ripples.json
  phenomenon nodes --search lerp
  phenomenon nodes --search reflection colour
  phenomenon nodes mix --format json";

/// What a name asks for.
enum Subject<'l> {
    Node(&'l Signature),
    Groups(Vec<Group<'l>>),
}

/// Runs the command.
///
/// # Errors
/// An unknown name, a file that cannot be used, or standard output that cannot be written.
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
    let file = arguments.name.as_deref().filter(|name| name.ends_with(".json"));
    if let Some(file) = file {
        let graph = graphs::read(Path::new(file), &library)?;
        match arguments.format {
            Format::Human => terminal::print(&human::phenomenon(&graph)),
            Format::Json => terminal::print_exactly(&json::phenomenon(&graph)),
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
    let groups = library.groups().iter().map(|group| group.name);
    if groups.clone().any(|group| group == name) {
        return Ok(Subject::Groups(grouped(library, Some(name))));
    }
    let names = library.iter().map(|(_, definition)| &*definition.signature.name);
    let help = match nearest(name, names.chain(groups)) {
        Some(near) => near.help(),
        None => "`phenomenon nodes` lists all there are".into(),
    };
    Err(Failure::new(format!("there is no node or group `{name}`"), help))
}
