//! How a command ends.

use std::fmt::Display;
use std::io;

/// A command that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Exit code 0.
    Fine,
    /// Exit code 1: findings, or a difference above the tolerance.
    Found,
    /// Exit code 2: a file could not be read; everything else was done.
    Unreadable,
}

/// A command that could not run to its end: exit code 2.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// Something the user can mend.
    #[error("{message}")]
    Refused {
        /// What is wrong, naming the flag or the file and the value.
        message: String,
        /// What to do.
        help: String,
    },
    /// Standard output cannot be written to.
    #[error("cannot write to standard output: {0}")]
    Output(io::Error),
    /// Whoever read our output has stopped reading; no failure at all.
    #[error("standard output is closed")]
    ClosedPipe,
}

impl Failure {
    /// Something the user can mend, and how.
    pub fn new(message: impl Display, help: impl Display) -> Self {
        Failure::Refused { message: message.to_string(), help: help.to_string() }
    }

    /// What to do; empty where nothing is known.
    pub fn help(&self) -> &str {
        match self {
            Failure::Refused { help, .. } => help,
            Failure::Output(_) | Failure::ClosedPipe => "",
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Failure::ClosedPipe
        } else {
            Failure::Output(error)
        }
    }
}
