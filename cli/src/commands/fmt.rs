//! `phenomenon fmt`: files in their canonical form.

use std::path::PathBuf;

use clap::ValueHint;
use phenomenon_compiler::document::{Document, MAX_FILE_BYTES, all_mistakes, canonical};

use crate::difference;
use crate::failure::{Failure, Outcome};
use crate::inputs::{self, Input};
use crate::outputs;
use crate::report;
use crate::terminal;

/// Writes graphs and scenes in the canonical form: two spaces, short values on one line. Order,
/// numbers, strings and single blank lines stay as they are.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Files, folders (every .json file in them that is a graph or a scene), or `-` for standard
    /// input, which goes to standard output.
    #[arg(required = true, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    paths: Vec<PathBuf>,
    /// Write nothing; name the files that are in another form and exit with 1.
    #[arg(long)]
    check: bool,
    /// Write nothing; show what would change and exit with 1 where something would.
    #[arg(long)]
    diff: bool,
}

const EXAMPLES: &str = "\
A file is written beside and renamed, so that it is never cut; links and permissions stay.

Examples:
  phenomenon fmt graphs scenes
  phenomenon fmt --diff graphs | less
  phenomenon fmt - < glass.json

Exit codes:
  0  fine
  1  with --check or --diff: a file is in another form
  2  wrong usage, a file that cannot be read or written, or nothing to do in the folders named";

/// Runs the command.
///
/// # Errors
/// There is nothing to format, or standard output cannot be written.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let found = inputs::find(&arguments.paths).once();
    let mut outcome = Outcome::Fine;
    for failure in &found.failures {
        terminal::complain(failure);
        outcome = Outcome::Unreadable;
    }
    let mut looked_at = 0;
    for input in &found.inputs {
        let document = match inputs::read(&input.path) {
            Ok(document) if input.in_folder && !inputs::is_ours(&document) => continue,
            Ok(document) => document,
            Err(finding) if input.in_folder && inputs::is_foreign_text(&finding) => continue,
            Err(finding) => {
                looked_at += 1;
                report::tell(&all_mistakes(*finding), 0);
                outcome = Outcome::Unreadable;
                continue;
            }
        };
        looked_at += 1;
        match format(arguments, input, &document) {
            Ok(told) if told && outcome == Outcome::Fine => outcome = Outcome::Found,
            Ok(_) => {}
            // The other files are none the worse for it.
            Err(failure @ Failure::Refused { .. }) => {
                terminal::complain(&failure);
                outcome = Outcome::Unreadable;
            }
            Err(failure) => return Err(failure),
        }
    }
    if looked_at == 0 && outcome == Outcome::Fine {
        return Err(inputs::nothing_in(&arguments.paths, "format"));
    }
    Ok(outcome)
}

/// Brings a file into the canonical form, or tells of it; whether it was told of.
fn format(arguments: &Arguments, input: &Input, document: &Document) -> Result<bool, Failure> {
    let (old, new) = (&document.file.text, canonical(document));
    let name = input.path.display();
    if new.len() > MAX_FILE_BYTES {
        let problem = format!("the canonical form of `{name}` is too large to be read again");
        return Err(Failure::new(problem, "split the file, or leave it as it is"));
    }
    if arguments.diff {
        terminal::print_exactly(&difference::unified(&name.to_string(), old, &new))?;
    } else if arguments.check {
        if new != *old {
            terminal::print(&format!("{name}\n"))?;
        }
    } else if inputs::is_stream(&input.path) {
        terminal::print_exactly(&new)?;
    } else if new != *old {
        outputs::rewrite(&input.path, &new)?;
    }
    Ok((arguments.diff || arguments.check) && new != *old)
}
