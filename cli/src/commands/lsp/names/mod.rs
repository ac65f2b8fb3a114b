//! What a file gives names to, and where it uses them.

mod index;
mod scan;

pub use index::{Name, NameKind};
pub use scan::index;
