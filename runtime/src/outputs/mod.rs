//! Files that are written whole or not at all.
//!
//! Bytes go to a temporary file beside the target, to the disk, and only then under the target's
//! name: whatever happens on the way, what was there before is still there, whole.

mod error;
mod identity;
mod target;
mod write;

pub use error::{WriteCause, WriteError};
pub use identity::FileIdentity;
pub use target::is_descriptor;
pub use write::{require_writable, write};
