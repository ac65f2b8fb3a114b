//! `phenomenon completions`.

use clap::{Args, ValueEnum};
use clap_complete::Shell;

use crate::failure::{Failure, Outcome};
use crate::terminal;

/// Write a script that completes commands, flags and files in a shell.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  phenomenon completions bash > ~/.local/share/bash-completion/completions/phenomenon
  phenomenon completions zsh > ~/.zfunc/_phenomenon
  phenomenon completions fish > ~/.config/fish/completions/phenomenon.fish";

/// Runs the command; `grammar` is that of the program.
///
/// # Errors
/// Standard output cannot be written.
pub fn run(arguments: &Arguments, grammar: clap::Command) -> Result<Outcome, Failure> {
    terminal::print_exactly(&script(arguments.shell, grammar)?)?;
    Ok(Outcome::Fine)
}

fn script(shell: Shell, mut grammar: clap::Command) -> Result<String, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut grammar, "phenomenon", &mut script);
    String::from_utf8(script).map_err(|error| {
        let shell = shell.to_possible_value().map_or_else(String::new, |it| it.get_name().into());
        Failure::new(format!("the script for {shell} is no text: {error}"), "please report this")
    })
}
