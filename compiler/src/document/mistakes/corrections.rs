//! How brackets that do not come out even are to be read.

use super::mistake::{MAX_MISTAKES, Mistake};

/// How brackets are to be read so that they come out even.
#[derive(Debug, Default)]
pub(super) struct Corrections {
    /// Before the token at a byte, so many closing brackets are missing; by byte.
    pub missing: Vec<(usize, usize)>,
    /// Closing brackets, by byte, that are too many.
    pub extra: Vec<usize>,
    /// What is wrong with brackets.
    pub mistakes: Vec<Mistake>,
    /// Whether nothing was found out, for there are too many other mistakes.
    pub given_up: bool,
}

impl Corrections {
    /// Keeps a mistake, as far as it will be told.
    pub fn tell(&mut self, mistake: Mistake) {
        if self.mistakes.len() < MAX_MISTAKES {
            self.mistakes.push(mistake);
        }
    }
}
