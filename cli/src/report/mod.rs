//! Findings as text, in the formats of `check`.

mod excerpt;
mod format;
mod github;
mod human;
mod json;
mod sarif;
mod shown;

pub use format::Format;
pub use human::tell;
pub use shown::Report;
