//! The progress bar.

use std::io::{self, IsTerminal};

use indicatif::{ProgressBar, ProgressStyle};

use super::look::{Look, Stream};

/// A progress bar on a terminal, nothing in a pipe, on a terminal that cannot move its cursor, or where `quiet`.
pub fn progress(unit: &str, quiet: bool) -> ProgressBar {
    let look = Look::of(Stream::Error);
    if quiet || !io::stderr().is_terminal() || look.dumb {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(1);
    // What stands beside the bar takes some thirty columns.
    let width = look.width.saturating_sub(32 + unit.len()).clamp(4, 40);
    let template = format!("{{bar:{width}}} {{pos}}/{{len}} {unit} {{eta}} left");
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(if look.ascii { style.progress_chars("#>-") } else { style });
    }
    bar
}
