//! Findings: what is wrong in a file, where, and what to do about it. Plain data; the command line
//! decides how to show them.

mod advice;
mod codes;
mod digits;
mod documentation;
mod escape;
mod finding;
mod findings;
pub mod peers;
mod severity;
mod source;
mod suggest;
pub mod synonyms;
mod tell_once;
mod wording;

pub use advice::Advice;
pub use codes::{Code, Explanation};
pub use digits::{grouped, rounded};
pub use documentation::documentation;
pub use escape::{escaped, is_deceptive};
pub use finding::{Finding, Related};
pub use findings::{Findings, KEPT_FINDINGS, SHOWN_FINDINGS};
pub use severity::Severity;
pub use source::{Place, SourceFile};
pub(crate) use suggest::is_near;
pub use suggest::{Suggestion, Suggestions, nearest};
pub use tell_once::TellOnce;
pub(crate) use wording::shown;
pub use wording::{listed, listed_or, shortened};
