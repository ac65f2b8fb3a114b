//! The format a file is written for. It is a key of its own: `version` belongs to the author.

use crate::diagnostics::{Code, shortened};

use super::{Reader, Value, ValueKind, numbers};

/// The newest format of graph and scene files that is read. Files that say nothing have format 1.
pub const FORMAT: i64 = 1;

/// Whether a number is whole and above the newest format, however large.
fn is_newer(text: &str) -> bool {
    matches!(numbers::whole(text), numbers::Whole::Number(format) if format > i128::from(FORMAT))
}

/// Whether a file says that it is of a newer format than any that is read.
pub(crate) fn is_newer_format(root: &Value) -> bool {
    let format = root.get("format").map(|value| &value.kind);
    matches!(format, Some(ValueKind::Number(text)) if is_newer(text))
}

impl<'d> Reader<'d> {
    /// Whether a file is of a format that is read. Of a newer one nothing is known, not even which keys it has: that
    /// is the one finding.
    pub fn reads_format(&mut self, root: &'d Value) -> bool {
        let Some(value) = root.get("format") else { return true };
        if let ValueKind::Number(text) = &value.kind
            && is_newer(text)
        {
            let format = shortened(text);
            let message =
                format!("this file has format {format}; the newest read here is {FORMAT}");
            let help = "read it with a newer version of the program";
            self.report(Code::NEWER_FORMAT, value, message, help);
            return false;
        }
        self.integer(value, "`format`", 1..=FORMAT);
        true
    }
}
