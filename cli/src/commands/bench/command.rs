//! The arguments of the command, and what it does.

use clap::{Args, Subcommand};

use super::{compile, render, shade};
use crate::failure::{Failure, Outcome};

/// Measure, each figure beside its baseline in the same run.
#[derive(Debug, Args)]
pub struct Arguments {
    #[command(subcommand)]
    question: Question,
}

#[derive(Debug, Subcommand)]
enum Question {
    Compile(compile::Arguments),
    Render(render::Arguments),
    Shade(shade::Arguments),
}

/// Runs the command.
///
/// # Errors
/// As the question says.
pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    match &arguments.question {
        Question::Compile(arguments) => compile::run(arguments),
        Question::Render(arguments) => render::run(arguments),
        Question::Shade(arguments) => shade::run(arguments),
    }
}
