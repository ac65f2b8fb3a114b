//! Findings: what is wrong in a file, where, and what to do about it. Plain data; the command line
//! decides how to show them.

mod codes;
mod digits;
mod documentation;
mod escape;
mod finding;
mod findings;
mod names;
mod source;
pub mod synonyms;

pub use codes::{Code, Explanation};
pub use digits::grouped;
pub use documentation::documentation;
pub use escape::{escaped, is_deceptive};
pub use finding::{Finding, Related, Severity};
pub use findings::{Findings, KEPT_FINDINGS, SHOWN_FINDINGS};
pub use names::{listed, listed_or, shortened};
pub use source::{Place, SourceFile};
