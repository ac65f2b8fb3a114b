//! Findings with excerpts, for people.

use std::fmt::{self, Write};

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, SourceCode, SourceSpan,
    ThemeCharacters, ThemeStyles,
};
use phenomenon_compiler::diagnostics::{Finding, Severity};

use super::excerpt::Excerpt;
use super::shown::Report;
use crate::terminal::{self, Look, Stream};

/// Writes findings to standard error, in colour on a terminal; nothing where there are none.
pub fn tell(findings: &[Finding], omitted: usize) {
    if findings.is_empty() && omitted == 0 {
        return;
    }
    let report = Report::new(findings.to_vec(), omitted);
    terminal::tell_drawn(text(&report, &Look::of(Stream::Error)).trim_end());
}

/// The findings, each with its excerpt, and their number.
pub fn text(report: &Report, look: &Look) -> String {
    let characters = if look.ascii { ThemeCharacters::ascii() } else { ThemeCharacters::unicode() };
    let styles = if look.color { ThemeStyles::ansi() } else { ThemeStyles::none() };
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme { characters, styles })
        .with_links(false)
        .with_width(look.width);
    let mut text = String::new();
    for finding in &report.shown {
        // Without an excerpt, or should it fail, the finding is still told in one line.
        let drawn = Excerpt::of(finding, look).and_then(|excerpt| {
            let shown = Shown::new(finding, excerpt, look);
            let mut drawn = String::new();
            handler.render_report(&mut drawn, &shown).ok().map(|()| drawn)
        });
        match drawn {
            Some(drawn) => text.push_str(&drawn),
            None => text.push_str(&plain(finding, look)),
        }
        text.push('\n');
    }
    text.push_str(&summary(report));
    text
}

fn plain(finding: &Finding, look: &Look) -> String {
    let mut text = format!("{finding}\n");
    for related in &finding.related {
        let (line, column) = related.place.line_column();
        let name = &related.place.file.name;
        let _ = writeln!(text, "  see {name}:{line}:{column}: {}", related.message);
    }
    look.wrapped(&terminal::shown(&text, look), "  ")
}

fn summary(report: &Report) -> String {
    let mut parts = Vec::new();
    for severity in [Severity::Error, Severity::Warning, Severity::Note] {
        match report.count(severity) {
            0 => {}
            1 => parts.push(format!("1 {severity}")),
            many => parts.push(format!("{many} {severity}s")),
        }
    }
    if report.omitted > 0 {
        parts.push(format!("{} more not shown", report.omitted));
    }
    if parts.is_empty() { String::new() } else { format!("{}\n", parts.join(", ")) }
}

/// A finding as miette draws it, all its texts such as a terminal can show them.
struct Shown<'f> {
    finding: &'f Finding,
    message: String,
    help: String,
    excerpt: Excerpt,
}

impl<'f> Shown<'f> {
    fn new(finding: &'f Finding, excerpt: Excerpt, look: &Look) -> Self {
        let mut help = finding.help.clone();
        for related in excerpt.unmarked.iter().map(|at| &finding.related[*at]) {
            let (line, column) = related.place.line_column();
            let name = &related.place.file.name;
            let _ = write!(help, "\nsee {name}:{line}:{column}: {}", related.message);
        }
        let shown = |text: &str| terminal::shown(text, look).into_owned();
        Self { finding, message: shown(&finding.message), help: shown(&help), excerpt }
    }
}

impl fmt::Debug for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Shown<'_> {}

impl Diagnostic for Shown<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(format!("{}[{}]", self.finding.severity, self.finding.code)))
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.finding.severity {
            Severity::Error => miette::Severity::Error,
            Severity::Warning => miette::Severity::Warning,
            Severity::Note => miette::Severity::Advice,
        })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        if self.help.is_empty() { None } else { Some(Box::new(&self.help)) }
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let marks = self.excerpt.marks.iter().enumerate().map(|(at, mark)| {
            let span = SourceSpan::from((mark.shown.start, mark.shown.len()));
            match at {
                0 => LabeledSpan::new_primary_with_span(mark.label.clone(), span),
                _ => LabeledSpan::new_with_span(mark.label.clone(), span),
            }
        });
        Some(Box::new(marks))
    }
}
