//! Findings as workflow commands of GitHub Actions.

use std::fmt::Write;

use phenomenon_compiler::diagnostics::Severity;

use super::shown::Report;

/// One `::error …::message` a finding.
pub fn text(report: &Report) -> String {
    let mut text = String::new();
    for finding in &report.shown {
        let command = match finding.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "notice",
        };
        let place = &finding.place;
        let (line, column) = place.line_column();
        let (end_line, end_column) = place.end_line_column();
        let _ = write!(
            text,
            "::{command} file={},line={line},endLine={end_line},col={column},",
            property(&place.file.name)
        );
        // GitHub takes an end column only where the range is within one line.
        if line == end_line {
            let _ = write!(text, "endColumn={end_column},");
        }
        let message = match finding.help.as_str() {
            "" => finding.message.clone(),
            help => format!("{}\nhelp: {help}", finding.message),
        };
        let _ = writeln!(text, "title={}::{}", property(finding.code.0), data(&message));
    }
    if report.omitted > 0 {
        let _ = writeln!(text, "::notice::{} more findings not shown", report.omitted);
    }
    text
}

/// A message, escaped as the workflow commands ask.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// A property, in which also `:` and `,` have a meaning.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
