//! `phenomenon man`.

use std::path::{Path, PathBuf};

use clap::{Args, Command, ValueHint};
use clap_mangen::Man;
use phenomenon_compiler::diagnostics::nearest;
use phenomenon_compiler::document::open_file;

use crate::failure::{Failure, Outcome};
use crate::outputs::Output;
use crate::terminal;

/// Write manual pages.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The command whose page is written; otherwise that of the program
    #[arg(conflicts_with = "output")]
    command: Option<String>,

    /// Write the pages of the program and of every command to this folder
    #[arg(short, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  phenomenon man render | man -l -
  phenomenon man -o ~/.local/share/man/man1";

/// Runs the command; `grammar` is that of the program.
///
/// # Errors
/// There is no such command, or a page cannot be written.
pub fn run(arguments: &Arguments, grammar: Command) -> Result<Outcome, Failure> {
    let pages = pages(grammar)?;
    if let Some(folder) = &arguments.output {
        write(folder, &pages)?;
        return Ok(Outcome::Fine);
    }
    let name = match &arguments.command {
        Some(command) => format!("phenomenon-{command}"),
        None => "phenomenon".into(),
    };
    let Some((_, page)) = pages.iter().find(|(known, _)| *known == name) else {
        let command = arguments.command.as_deref().unwrap_or_default();
        let names = pages.iter().filter_map(|(name, _)| name.strip_prefix("phenomenon-"));
        let help = match nearest(command, names) {
            Some(near) => near.help(),
            None => "`phenomenon --help` lists the commands".into(),
        };
        return Err(Failure::new(format!("there is no command `{command}`"), help));
    };
    terminal::print_exactly(page)?;
    Ok(Outcome::Fine)
}

/// Pages by name: that of the program, and one a command.
fn pages(mut program: Command) -> Result<Vec<(String, String)>, Failure> {
    // Usage of a command names the program only then.
    program.build();
    let mut pages = vec![page(&program, "phenomenon".into())?];
    let mut pending: Vec<(String, &Command)> =
        program.get_subcommands().map(|command| ("phenomenon".into(), command)).collect();
    while let Some((of, command)) = pending.pop() {
        if command.get_name() == "help" {
            continue;
        }
        let name = format!("{of}-{}", command.get_name());
        pages.push(page(command, name.clone())?);
        pending.extend(command.get_subcommands().map(|inner| (name.clone(), inner)));
    }
    pages.sort();
    Ok(pages)
}

fn page(command: &Command, name: String) -> Result<(String, String), Failure> {
    let mut bytes = Vec::new();
    let man = Man::new(command.clone()).title(name.as_str()).manual("Phenomenon");
    man.render(&mut bytes)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        Failure::new(format!("the page {name} is no text: {error}"), "please report this")
    })?;
    Ok((name, text))
}

fn write(folder: &Path, pages: &[(String, String)]) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::new(format!("-o {}: {error}", folder.display()), "name another folder")
    })?;
    let paths: Vec<PathBuf> =
        pages.iter().map(|(name, _)| folder.join(format!("{name}.1"))).collect();
    paths.iter().try_for_each(|path| require_own(path))?;
    for ((_, page), path) in pages.iter().zip(&paths) {
        let path = path.as_path();
        Output { flag: "-o", path }.write(page)?;
    }
    Ok(())
}

/// Fails where something is under the name that is no page of an earlier run: the names were not
/// chosen by whoever gave the folder.
fn require_own(path: &Path) -> Result<(), Failure> {
    use std::io::Read;
    // What cannot be opened is told of when it is written.
    let Ok((file, _)) = open_file(path) else { return Ok(()) };
    let mut start = Vec::new();
    file.take(4096).read_to_end(&mut start)?;
    let is_own = String::from_utf8_lossy(&start).lines().any(|line| line.starts_with(TITLE));
    if is_own {
        return Ok(());
    }
    let message = format!("-o: {} is no manual page of this program", path.display());
    Err(Failure::new(message, "name another folder, or move the file away"))
}

/// How the line of a page that names it begins.
const TITLE: &str = ".TH phenomenon";
