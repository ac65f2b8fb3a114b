//! The formats in which findings are written.

use clap::ValueEnum;

use super::shown::Report;
use super::{github, human, json, sarif};
use crate::failure::Failure;
use crate::terminal::{self, Look, Stream};

/// How findings are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// With an excerpt of the file, for people.
    #[default]
    Human,
    /// One object, for programs.
    Json,
    /// SARIF 2.1.0, for code scanning services.
    Sarif,
    /// Workflow commands, which GitHub shows beside the lines.
    Github,
}

impl Report {
    /// Writes the report to standard output.
    ///
    /// # Errors
    /// Standard output cannot be written to.
    pub fn print(&self, format: Format) -> Result<(), Failure> {
        match format {
            Format::Human => terminal::print_drawn(&human::text(self, &Look::of(Stream::Output))),
            Format::Json => terminal::print_exactly(&json::text(self)),
            Format::Sarif => terminal::print_exactly(&sarif::text(self)),
            // A log of people, coloured by what it finds in it.
            Format::Github => terminal::print(&github::text(self)),
        }
    }
}
