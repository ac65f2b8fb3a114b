//! `phenomenon schema`: the JSON Schema of graph and scene files.

use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::scene_file::file_schema;

use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Writes the JSON Schema of graph and scene files, from which editors complete and check them.
#[derive(Debug, clap::Args)]
pub struct Arguments {}

/// Runs the command.
pub fn run(_: &Arguments) -> Result<Outcome, Failure> {
    terminal::print_exactly(&file_schema(&NodeLibrary::standard()))?;
    Ok(Outcome::Fine)
}
