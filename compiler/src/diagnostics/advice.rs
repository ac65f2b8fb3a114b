//! What is said of a name that is not there.

use super::Suggestion;
use super::synonyms::Synonym;

/// What to do about a name that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Advice {
    /// What to do.
    pub help: String,
    /// What to put in its place, where nothing else can be meant.
    pub fix: Option<String>,
}

impl Advice {
    /// What the name means elsewhere comes before what is spelled nearly so; where neither is known there
    /// is another help.
    pub fn of(
        synonym: Option<Synonym>,
        near: Option<Suggestion<'_>>,
        otherwise: impl FnOnce() -> String,
    ) -> Self {
        match (synonym, near) {
            (_, Some(near)) if near.distance == 0 => near.into(),
            (Some(synonym), _) => Self { help: synonym.help(), fix: synonym.fix() },
            (None, Some(near)) => near.into(),
            (None, None) => otherwise().into(),
        }
    }
}

impl From<Suggestion<'_>> for Advice {
    fn from(near: Suggestion<'_>) -> Self {
        Self { help: near.help(), fix: near.fix() }
    }
}

impl From<String> for Advice {
    /// Help alone: what is meant is not known.
    fn from(help: String) -> Self {
        Self { help, fix: None }
    }
}
