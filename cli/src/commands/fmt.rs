//! `phenomenon fmt`: files in their canonical form.

use std::path::PathBuf;

use phenomenon_compiler::document::{MAX_FILE_BYTES, canonical, read_file};

use crate::failure::{Failure, Outcome};
use crate::report;
use crate::terminal;

/// Writes graphs and scenes in the canonical form: two spaces, short values on one line. Order,
/// numbers, strings and single blank lines stay as they are.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The files.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Write nothing; name the files that are in another form and exit with 1.
    #[arg(long)]
    check: bool,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut outcome = Outcome::Fine;
    for path in &arguments.files {
        let document = match read_file(path) {
            Ok(document) => document,
            Err(finding) => {
                report::tell(&[*finding], 0);
                outcome = Outcome::Unreadable;
                continue;
            }
        };
        let text = canonical(&document);
        if text == document.file.text {
            continue;
        }
        let name = path.display();
        if text.len() > MAX_FILE_BYTES {
            let problem = format!("the canonical form of `{name}` is too large to be read again");
            return Err(Failure::new(problem, "split the file, or leave it as it is"));
        }
        if arguments.check {
            terminal::print(&format!("{name}\n"))?;
            if outcome == Outcome::Fine {
                outcome = Outcome::Found;
            }
        } else {
            std::fs::write(path, text).map_err(|error| {
                Failure::new(format!("cannot write `{name}`: {error}"), "check its permissions")
            })?;
        }
    }
    Ok(outcome)
}
