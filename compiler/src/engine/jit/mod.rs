//! Machine code for pure segments, by Cranelift.

mod code;
mod error;
mod lower;

pub use code::JitCode;
pub use error::JitError;
