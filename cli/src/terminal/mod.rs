//! Standard output, standard error and the progress bar.

use std::io::{self, IsTerminal, Write};

use indicatif::{ProgressBar, ProgressStyle};

use crate::failure::Failure;

/// Writes `text` to standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    output.write_all(text.as_bytes())?;
    output.flush()?;
    Ok(())
}

/// Writes a line to standard error; that it cannot be written is no reason to stop.
pub fn tell(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Says why a command failed and what to do.
pub fn complain(failure: &Failure) {
    tell(&format!("error: {failure}"));
    if !failure.help().is_empty() {
        tell(&format!("  help: {}", failure.help()));
    }
}

/// A progress bar on a terminal, nothing in a pipe or where `quiet`.
pub fn progress(unit: &str, quiet: bool) -> ProgressBar {
    if quiet || !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(1);
    let template = format!("{{bar:40}} {{pos}}/{{len}} {unit} {{eta}} left");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    bar
}
