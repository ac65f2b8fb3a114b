//! Findings: what is wrong in a file, where, and what to do about it. Plain data; the command line
//! decides how to show them.

mod codes;
mod documentation;
mod finding;
mod findings;
mod source;

pub use codes::{Code, Explanation};
pub use documentation::documentation;
pub use finding::{Finding, Related, Severity};
pub use findings::{Findings, KEPT_FINDINGS, SHOWN_FINDINGS};
pub use source::{Place, SourceFile};
