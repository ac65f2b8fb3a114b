//! Findings as text, in the formats of `check`.

mod excerpt;
mod github;
mod human;
mod json;
mod sarif;

use clap::ValueEnum;
use phenomenon_compiler::diagnostics::{Finding, SHOWN_FINDINGS, Severity};

use crate::failure::Failure;
use crate::terminal::{self, Look, Stream};

pub use human::tell;

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

/// The findings of a run, as far as they are shown.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What is shown.
    pub shown: Vec<Finding>,
    /// How many are not.
    pub omitted: usize,
}

impl Report {
    /// A report of `findings`, of which [`SHOWN_FINDINGS`] are shown, and of `omitted` more. Errors are
    /// shown before anything else is, so that nothing hides one; the order stays.
    pub fn new(findings: Vec<Finding>, omitted: usize) -> Self {
        let hidden = findings.len().saturating_sub(SHOWN_FINDINGS);
        let mut by_severity: Vec<usize> = (0..findings.len()).collect();
        by_severity.sort_by_key(|at| std::cmp::Reverse(findings[*at].severity));
        let mut is_shown = vec![false; findings.len()];
        for at in by_severity.into_iter().take(SHOWN_FINDINGS) {
            is_shown[at] = true;
        }
        let shown = findings.into_iter().zip(is_shown).filter(|(_, is_shown)| *is_shown);
        Self { shown: shown.map(|(finding, _)| finding).collect(), omitted: omitted + hidden }
    }

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

    /// How many shown findings have that severity.
    fn count(&self, severity: Severity) -> usize {
        self.shown.iter().filter(|finding| finding.severity == severity).count()
    }
}
