//! Which findings are shown.

use phenomenon_compiler::diagnostics::{Finding, SHOWN_FINDINGS, Severity};

/// The findings of a run, as far as they are shown.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What is shown.
    pub shown: Vec<Finding>,
    /// How many are not.
    pub omitted: usize,
}

impl Report {
    /// A report of `findings`, of which [`SHOWN_FINDINGS`] are shown, and of `omitted` more. Errors are
    /// shown before anything else is, so that nothing hides one; the order stays.
    pub fn new(findings: Vec<Finding>, omitted: usize) -> Self {
        let hidden = findings.len().saturating_sub(SHOWN_FINDINGS);
        let mut by_severity: Vec<usize> = (0..findings.len()).collect();
        by_severity.sort_by_key(|at| std::cmp::Reverse(findings[*at].severity));
        let mut is_shown = vec![false; findings.len()];
        for at in by_severity.into_iter().take(SHOWN_FINDINGS) {
            is_shown[at] = true;
        }
        let shown = findings.into_iter().zip(is_shown).filter(|(_, is_shown)| *is_shown);
        Self { shown: shown.map(|(finding, _)| finding).collect(), omitted: omitted + hidden }
    }

    /// How many shown findings have that severity.
    pub fn count(&self, severity: Severity) -> usize {
        self.shown.iter().filter(|finding| finding.severity == severity).count()
    }
}
