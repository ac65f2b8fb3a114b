//! A finding.

use super::{Advice, Code, Place, Severity, escaped};
use std::borrow::Cow;
use std::fmt;

/// Another place that belongs to a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// Where.
    pub place: Place,
    /// Why it matters here.
    pub message: String,
}

/// Something wrong, or worth knowing, about a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Stable code.
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, naming the node and the input.
    pub message: String,
    /// What to do.
    pub help: String,
    /// Where.
    pub place: Place,
    /// Other places that explain it.
    pub related: Vec<Related>,
    /// Text that, put in the finding's place, surely mends it.
    pub fix: Option<String>,
}

impl Finding {
    /// A finding of a code, with that code's severity. What could command a terminal, or hide or
    /// reorder what is read, is escaped in its texts, whoever's names are quoted there.
    pub fn new(
        code: Code,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self {
            code,
            severity: code.severity(),
            message: safe(message.into()),
            help: safe(help.into()),
            place,
            related: Vec::new(),
            fix: None,
        }
    }

    /// A name that is not there, with what may be meant.
    pub fn misspelt(code: Code, place: Place, message: impl Into<String>, advice: Advice) -> Self {
        Self { fix: advice.fix, ..Self::new(code, place, message, advice.help) }
    }

    /// The same with another place that explains it.
    #[must_use]
    pub fn with_related(mut self, place: Place, message: impl Into<String>) -> Self {
        self.related.push(Related { place, message: safe(message.into()) });
        self
    }

    /// The same with the text that mends it when put in its place.
    #[must_use]
    pub fn with_fix(mut self, text: impl Into<String>) -> Self {
        self.fix = Some(text.into());
        self
    }
}

/// A text of one line in which nothing deceives.
fn safe(text: String) -> String {
    match escaped(&text) {
        Cow::Borrowed(_) => text,
        Cow::Owned(safe) => safe,
    }
}

impl fmt::Display for Finding {
    /// One line, `file:line:column: severity[code]: message`, then the help.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (line, column) = self.place.line_column();
        let Self { code, severity, message, help, place, .. } = self;
        let file = escaped(&place.file.name);
        write!(f, "{file}:{line}:{column}: {severity}[{code}]: {message}")?;
        if !help.is_empty() {
            write!(f, "\n  help: {help}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostics::SourceFile;

    #[test]
    fn no_text_of_a_finding_deceives() {
        let file = std::sync::Arc::new(SourceFile::new("a\u{1b}[2J.json", "x"));
        let place = Place { file, start: 0, end: 1, path: String::new() };
        let name = "gnp.\u{202e}exe\u{7}";
        let finding = Finding::new(Code::SYNTAX, place.clone(), format!("no {name}"), name)
            .with_related(place, name)
            .with_fix(name);
        assert_eq!(finding.message, "no gnp.\\u{202e}exe\\u{7}");
        assert_eq!(finding.related[0].message, finding.help);
        assert_eq!(finding.fix.as_deref(), Some(name), "what is put in stays what it is");
        let told = finding.to_string();
        assert!(told.starts_with("a\\u{1b}[2J.json:1:1: error[syntax]: no gnp."), "{told}");
    }
}
