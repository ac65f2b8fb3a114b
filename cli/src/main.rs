//! `phenomenon`: checks, renders and evaluates shader graphs from the command line.

mod arguments;
mod commands;
mod difference;
mod failure;
mod graphs;
mod inputs;
mod numbers;
mod ours;
mod outputs;
mod report;
mod scenes;
mod terminal;
mod uri;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::commands::{
    bench, check, compare, completions, effects, eval, explain, fmt, lsp, man, nodes, render,
    schema, show,
};
use crate::failure::{Failure, Outcome};

/// Reads shader graphs, checks them, compiles them and renders pictures with them.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, max_term_width = 100, after_help = EXIT_CODES)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  fine
  1  check found something; compare found a difference above the tolerance; fmt would change a file
  2  wrong usage, a file that cannot be read or written, a graph or scene that cannot be used";

#[derive(Debug, Subcommand)]
enum Command {
    Bench(bench::Arguments),
    Check(check::Arguments),
    Compare(compare::Arguments),
    Completions(completions::Arguments),
    Effects(effects::Arguments),
    Eval(eval::Arguments),
    Explain(explain::Arguments),
    Fmt(fmt::Arguments),
    Lsp(lsp::Arguments),
    Man(man::Arguments),
    Nodes(nodes::Arguments),
    Render(render::Arguments),
    Schema(schema::Arguments),
    Show(show::Arguments),
}

/// Commands and flags, for the command line and what is derived from them: completions, manual pages and hints.
fn grammar() -> clap::Command {
    arguments::with_dashed_numbers(CommandLine::command())
}

fn main() -> ExitCode {
    outlive_the_file_size_limit();
    let given = grammar().try_get_matches();
    let command_line = match given.and_then(|given| CommandLine::from_arg_matches(&given)) {
        Ok(command_line) => command_line,
        Err(error) => {
            let given: Vec<String> =
                std::env::args_os().skip(1).map(|it| it.to_string_lossy().into_owned()).collect();
            let error = arguments::explained(error, &grammar(), &given);
            // Help goes to standard output with code 0.
            terminal::answer(&error);
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    match run(command_line.command) {
        Ok(Outcome::Fine) => ExitCode::SUCCESS,
        Ok(Outcome::Found) => ExitCode::from(1),
        Ok(Outcome::Unreadable) => ExitCode::from(2),
        Err(Failure::ClosedPipe) => ExitCode::SUCCESS,
        Err(failure) => {
            terminal::complain(&failure);
            ExitCode::from(2)
        }
    }
}

/// A file that grows past `ulimit -f` would end the program by a signal. Where that is caught, writing
/// fails like on a full disk, and can be told of.
fn outlive_the_file_size_limit() {
    #[cfg(unix)]
    {
        let caught = std::sync::Arc::default();
        // Without it the file that is written is still whole or not there: only the message is lost.
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, caught);
    }
}

fn run(command: Command) -> Result<Outcome, Failure> {
    match command {
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Completions(arguments) => completions::run(&arguments, grammar()),
        Command::Effects(arguments) => effects::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Fmt(arguments) => fmt::run(&arguments),
        Command::Lsp(arguments) => lsp::run(&arguments),
        Command::Man(arguments) => man::run(&arguments, grammar()),
        Command::Nodes(arguments) => nodes::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Show(arguments) => show::run(&arguments),
    }
}
