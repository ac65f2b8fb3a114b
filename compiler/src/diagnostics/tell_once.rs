//! Findings that are told once.

use std::collections::HashSet;

use super::codes::Code;
use super::finding::Finding;

/// What was told already. A file that several others use is checked with each of them, and the same
/// is found in it each time.
#[derive(Debug, Default)]
pub struct TellOnce(HashSet<(String, usize, Code, String)>);

impl TellOnce {
    /// Whether nothing was said yet of what a finding says: the same code and message at its place.
    pub fn is_new(&mut self, finding: &Finding) -> bool {
        let place = &finding.place;
        let (file, message) = (place.file.name.clone(), finding.message.clone());
        self.0.insert((file, place.start, finding.code, message))
    }
}
