//! The findings of one run.

use std::collections::HashSet;

use super::{Code, Finding, Place, Severity};

/// How many findings are kept; later ones are counted only, so that a file with a million mistakes
/// costs no more memory than one with this many.
pub const KEPT_FINDINGS: usize = 10_000;

/// How many findings of a run a report shows; the rest is a number.
pub const SHOWN_FINDINGS: usize = 1_000;

/// A code, the file and the bytes it is about, and what is said but for the numbers of turns.
type Told = (Code, String, usize, usize, String);

/// The findings of one run, bounded.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    kept: Vec<Finding>,
    /// How many of the kept are no errors.
    others: usize,
    /// Findings made but not kept, by severity: note, warning, error.
    omitted: [usize; 3],
    /// What was found where, if it is told once for a place.
    told: Option<HashSet<Told>>,
}

impl Findings {
    /// Tells what is the same but for the numbers of turns once for a place from here on: turns are
    /// written once.
    pub fn tell_once(&mut self) {
        self.told = Some(HashSet::new());
    }

    /// Adds a finding, or counts it where there are too many.
    pub fn push(&mut self, finding: Finding) {
        if let Some(told) = &mut self.told {
            let Place { file, start, end, .. } = &finding.place;
            let message = without_turns(&finding.message);
            if !told.insert((finding.code, file.name.clone(), *start, *end, message)) {
                return;
            }
        }
        if self.kept.len() < KEPT_FINDINGS {
            self.others += usize::from(finding.severity != Severity::Error);
            self.kept.push(finding);
            return;
        }
        let mut left_out = finding;
        // An error takes the place of what is none: no number of warnings may hide one.
        if left_out.severity == Severity::Error
            && self.others > 0
            && let Some(other) =
                self.kept.iter_mut().rev().find(|it| it.severity != Severity::Error)
        {
            std::mem::swap(other, &mut left_out);
            self.others -= 1;
        }
        self.omitted[left_out.severity as usize] += 1;
    }

    /// Whether later findings will only be counted: their texts need not be good.
    pub fn is_full(&self) -> bool {
        self.kept.len() >= KEPT_FINDINGS
    }

    /// How many errors there are, kept or not.
    pub fn errors(&self) -> usize {
        self.kept.len() - self.others + self.omitted[Severity::Error as usize]
    }

    /// Whether one of them is an error.
    pub fn has_errors(&self) -> bool {
        self.errors() > 0
    }

    /// How many were counted but not kept.
    pub fn omitted(&self) -> usize {
        self.omitted.iter().sum()
    }

    /// Those kept, to be changed in what does not order them.
    pub(crate) fn iter_mut(&mut self) -> impl Iterator<Item = &mut Finding> {
        self.kept.iter_mut()
    }

    /// Those kept, in the order made.
    pub fn iter(&self) -> impl Iterator<Item = &Finding> {
        self.kept.iter()
    }

    /// Those kept, in file order, errors first at one place.
    pub fn into_sorted(mut self) -> Vec<Finding> {
        let first = self.kept.first().map(|finding| finding.place.file.clone());
        self.kept.sort_by(|a, b| {
            let own = |finding: &Finding| first.as_ref() != Some(&finding.place.file);
            (own(a), &a.place.file.name, a.place.start, b.severity).cmp(&(
                own(b),
                &b.place.file.name,
                b.place.start,
                a.severity,
            ))
        });
        self.kept
    }
}

/// A message without the numbers in brackets that tell turns apart.
fn without_turns(message: &str) -> String {
    let mut parts = message.split('[');
    let mut same = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        same.push('[');
        same.push_str(part.trim_start_matches(|digit: char| digit.is_ascii_digit()));
    }
    same
}
