//! Machine code for pure segments, by Cranelift.

mod code;
mod error;
mod lower;
mod pieces;
mod plan;
pub(super) mod worker;

pub use code::JitCode;
pub use error::JitError;
pub use pieces::{Piece, Pieces};
pub use plan::Plan;
