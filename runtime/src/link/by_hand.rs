//! Which materials of a scene are written by hand.

use super::error::LinkError;
use super::notes::Note;
use crate::monoliths::{NoMonolith, NotWrittenByHand};

/// What was found so far.
#[derive(Default)]
pub(super) struct ByHand {
    /// Whether the material of an object is written by hand.
    pub found: bool,
    /// Why others are compiled instead; each once.
    compiled: Vec<NotWrittenByHand>,
}

impl ByHand {
    /// A material is compiled instead.
    pub fn missing(&mut self, why: NotWrittenByHand) {
        if !self.compiled.contains(&why) {
            self.compiled.push(why);
        }
    }

    /// What there is to say of a scene whose materials were all looked at.
    ///
    /// # Errors
    /// Monoliths were asked for, and of no object there is one.
    pub fn notes(self) -> Result<impl Iterator<Item = Note>, LinkError> {
        match self.compiled.first() {
            Some(why) if !self.found => Err(NoMonolith::NotWritten(why.clone()).into()),
            _ => Ok(self.compiled.into_iter().map(|why| Note::Compiled { why })),
        }
    }
}
