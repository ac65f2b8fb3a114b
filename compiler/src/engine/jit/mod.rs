//! Machine code for pure segments: ours for eight lanes, Cranelift's for four.

mod code;
mod cranelift;
mod error;
mod generator;
mod layout;
#[cfg(target_arch = "x86_64")]
mod native;
mod pieces;
mod plan;
mod recorder;
mod shared;
pub(super) mod worker;

pub use code::JitCode;
pub use error::JitError;
pub use generator::Generator;
pub use layout::{Layout, lay_out};
pub use pieces::{Piece, Pieces};
pub use plan::Plan;
