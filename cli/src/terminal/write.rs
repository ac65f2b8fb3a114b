//! What is written to standard output and standard error.

use std::io::{self, IsTerminal, Write};

use super::escape::{json_shown, shown};
use super::look::{Look, Stream};
use crate::failure::Failure;

/// Writes text for people to standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    print_drawn(&shown(text, &Look::of(Stream::Output)))
}

/// Writes text for programs to standard output as it is. On a terminal what cannot be seen is escaped as JSON does it,
/// which changes no value of a JSON file.
pub fn print_exactly(text: &str) -> Result<(), Failure> {
    if io::stdout().is_terminal() { print_drawn(&json_shown(text)) } else { print_drawn(text) }
}

/// Writes what is escaped already, and may be coloured, to standard output.
pub fn print_drawn(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    output.write_all(text.as_bytes())?;
    output.flush()?;
    Ok(())
}

/// Writes a line for people to standard error; that it cannot be written is no reason to stop.
pub fn tell(line: &str) {
    let look = Look::of(Stream::Error);
    tell_drawn(&look.wrapped(&shown(line, &look), ""));
}

/// Writes what is escaped already, and may be coloured, to standard error.
pub fn tell_drawn(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Says why a command failed and what to do.
pub fn complain(failure: &Failure) {
    let look = Look::of(Stream::Error);
    let say = |line: String, indent: &str| tell_drawn(&look.wrapped(&shown(&line, &look), indent));
    say(format!("error: {failure}"), "       ");
    if !failure.help().is_empty() {
        say(format!("  help: {}", failure.help()), "        ");
    }
}

/// Says what clap found wrong in the arguments, or what it was asked for.
pub fn answer(error: &clap::Error) {
    let plain = error.render().to_string();
    let look = Look::of(if error.use_stderr() { Stream::Error } else { Stream::Output });
    let shown = shown(&plain, &look);
    // A closed pipe is no reason to complain.
    let _ = match (shown == plain, error.use_stderr()) {
        // As clap writes it, in colours.
        (true, _) => error.print(),
        (false, true) => write!(io::stderr(), "{shown}"),
        (false, false) => write!(io::stdout(), "{shown}"),
    };
}
