//! Findings with excerpts, for people.

use std::fmt::{self, Write};
use std::io::IsTerminal;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError,
    MietteSpanContents, SourceCode, SourceSpan, SpanContents,
};
use phenomenon_compiler::diagnostics::{Finding, Place, Severity, SourceFile};

use super::Report;
use crate::terminal;

/// Longest line an excerpt shows, in bytes; a file may be one line.
const LONGEST_LINE: usize = 400;
/// Most other places shown in the excerpt of one finding.
const MOST_LABELS: usize = 8;

/// Writes findings to standard error, in colour on a terminal; nothing where there are none.
pub fn tell(findings: &[Finding], omitted: usize) {
    if findings.is_empty() && omitted == 0 {
        return;
    }
    let color = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let report = Report::new(findings.to_vec(), omitted);
    terminal::tell(text(&report, color).trim_end());
}

/// The findings, each with its excerpt, and their number.
pub fn text(report: &Report, color: bool) -> String {
    let theme = if color { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_links(false).with_width(100);
    let mut text = String::new();
    for finding in &report.shown {
        let excerpt = Excerpt::of(finding);
        // Without an excerpt, or should it fail, the finding is still told in one line.
        let drawn = excerpt.and_then(|excerpt| {
            let mut drawn = String::new();
            handler.render_report(&mut drawn, &excerpt).ok().map(|()| drawn)
        });
        match drawn {
            Some(drawn) => text.push_str(&drawn),
            None => text.push_str(&plain(finding)),
        }
        text.push('\n');
    }
    text.push_str(&summary(report));
    text
}

fn plain(finding: &Finding) -> String {
    let mut text = format!("{finding}\n");
    for related in &finding.related {
        let (line, column) = related.place.line_column();
        let name = &related.place.file.name;
        let _ = writeln!(text, "  see {name}:{line}:{column}: {}", related.message);
    }
    text
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

/// A finding as miette draws it.
struct Excerpt<'f> {
    finding: &'f Finding,
    source: Lines<'f>,
}

impl<'f> Excerpt<'f> {
    /// None where there is no text to show, or its lines are too long to be read.
    fn of(finding: &'f Finding) -> Option<Self> {
        let source = Lines(&finding.place.file);
        let places = std::iter::once(&finding.place)
            .chain(finding.related.iter().map(|related| &related.place))
            .filter(|place| place.file == finding.place.file)
            .take(MOST_LABELS);
        let readable = places.into_iter().all(|place| source.can_show(place));
        (readable && !finding.place.file.text.is_empty()).then_some(Self { finding, source })
    }
}

impl fmt::Debug for Excerpt<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Excerpt<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.finding.message)
    }
}

impl std::error::Error for Excerpt<'_> {}

impl Diagnostic for Excerpt<'_> {
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
        let mut help = self.finding.help.clone();
        for related in &self.finding.related {
            if related.place.file != self.finding.place.file {
                let (line, column) = related.place.line_column();
                let name = &related.place.file.name;
                let _ = write!(help, "\nsee {name}:{line}:{column}: {}", related.message);
            }
        }
        if help.is_empty() { None } else { Some(Box::new(help)) }
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.source)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let own = &self.finding.place;
        let span = |place: &Place| SourceSpan::from((place.start, place.end - place.start));
        let first = LabeledSpan::new_primary_with_span(None, span(own));
        let others = self
            .finding
            .related
            .iter()
            .filter(move |related| related.place.file == own.file)
            .take(MOST_LABELS - 1)
            .map(move |related| {
                LabeledSpan::new_with_span(Some(related.message.clone()), span(&related.place))
            });
        Some(Box::new(std::iter::once(first).chain(others)))
    }
}

/// Lines of a file, found through its index: miette's own reading counts from the start of the file
/// for every excerpt.
struct Lines<'f>(&'f SourceFile);

impl Lines<'_> {
    /// Start of the line `before` lines above the one that holds `byte`; none where a line on the
    /// way is too long to be shown.
    fn line_start(&self, byte: usize, before: usize) -> Option<usize> {
        let text = self.0.text.as_bytes();
        let mut end = byte.min(text.len());
        for step in 0..=before {
            let from = end.saturating_sub(LONGEST_LINE);
            match text[from..end].iter().rposition(|byte| *byte == b'\n') {
                Some(at) if step == before => return Some(from + at + 1),
                Some(at) => end = from + at,
                None if from == 0 => return Some(0),
                None => return None,
            }
        }
        Some(end)
    }

    /// End of the line `after` lines below the one that holds `byte`, its line break excluded; none
    /// where a line on the way is too long to be shown.
    fn line_end(&self, byte: usize, after: usize) -> Option<usize> {
        let text = self.0.text.as_bytes();
        let mut start = byte.min(text.len());
        for step in 0..=after {
            let to = (start + LONGEST_LINE).min(text.len());
            match text[start..to].iter().position(|byte| *byte == b'\n') {
                Some(at) if step == after => return Some(start + at),
                Some(at) => start += at + 1,
                None if to == text.len() => return Some(to),
                None => return None,
            }
        }
        Some(start)
    }

    /// Whether the lines an excerpt of the place shows are few and short enough for it.
    fn can_show(&self, place: &Place) -> bool {
        let (Some(start), Some(end)) =
            (self.line_start(place.start, 1), self.line_end(place.end, 1))
        else {
            return false;
        };
        let lines = self.0.text.get(start..end).unwrap_or_default().split('\n');
        place.end - place.start <= 4 * LONGEST_LINE
            && lines.map(str::len).max().unwrap_or(0) <= LONGEST_LINE
    }
}

impl SourceCode for Lines<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let length = self.0.text.len();
        if span.offset() + span.len() > length {
            return Err(MietteError::OutOfBounds);
        }
        if (before, after) == (0, 0) {
            // Asked for the place alone, from which the heading takes line and column.
            let (line, column) = self.0.line_column(span.offset());
            let data = &self.0.text.as_bytes()[span.offset()..span.offset() + span.len()];
            let name = self.0.name.clone();
            let (line, column) = (line - 1, column - 1);
            return Ok(Box::new(MietteSpanContents::new_named(name, data, *span, line, column, 1)));
        }
        let last = span.offset() + span.len().saturating_sub(1);
        let (Some(start), Some(end)) =
            (self.line_start(span.offset(), before), self.line_end(last, after))
        else {
            return Err(MietteError::OutOfBounds);
        };
        let (line, _) = self.0.line_column(start);
        let data = &self.0.text.as_bytes()[start..end];
        let lines = data.iter().filter(|byte| **byte == b'\n').count() + 1;
        Ok(Box::new(MietteSpanContents::new_named(
            self.0.name.clone(),
            data,
            SourceSpan::from((start, end - start)),
            line - 1,
            0,
            lines,
        )))
    }
}
