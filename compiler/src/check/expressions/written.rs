//! What became of the expressions of a file.

use std::collections::HashMap;

use crate::diagnostics::Findings;
use crate::document::{Member, Value};
use crate::graph::Expression;

/// A phenomenon with nodes in the place of its expressions.
pub(in crate::check) struct Rewritten {
    /// The phenomenon. Places in it are those of the file.
    pub root: Value,
    /// Where the nodes came from that were written, by name.
    pub texts: HashMap<String, Text>,
    /// The expressions, by the name of their nodes, which have `#` and a number behind it.
    pub expressions: Vec<Expression>,
    /// The bytes of the texts of expressions, ascending.
    pub spans: Vec<(usize, usize)>,
}

impl Rewritten {
    /// Takes away what would be put into the text of an expression, though it was made for JSON. The word of a choice
    /// stays, between other quotes. The first findings, so `many`, are of the expressions themselves.
    pub fn mend_fixes(&self, findings: &mut Findings, many: usize) {
        for finding in findings.iter_mut().skip(many) {
            let Some(fix) = &finding.fix else { continue };
            let (start, end) = (finding.place.start, finding.place.end);
            let after = self.spans.partition_point(|(first, _)| *first <= start);
            if after.checked_sub(1).is_none_or(|at| end > self.spans[at].1) {
                continue;
            }
            let word = fix.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
            let is_word = |word: &&str| word.chars().all(|c| c.is_alphanumeric() || c == '_');
            let quoted = finding.place.text().starts_with('\'');
            finding.fix = word.filter(is_word).filter(|_| quoted).map(|word| format!("'{word}'"));
        }
    }
}

/// The text a node was written for.
#[derive(Clone, Debug)]
pub(in crate::check) struct Text {
    /// The operator, or the name of the function.
    pub mark: String,
    /// The part of the expression that is its value.
    pub whole: String,
}

/// What is made of the expressions of a file, as it grows.
#[derive(Default)]
pub(super) struct Output {
    /// The nodes.
    pub members: Vec<Member>,
    /// Where they came from.
    pub texts: HashMap<String, Text>,
}
