//! The scalar operations of a pure segment: what the JIT fuses, and the passes that prepare them.
//!
//! Recorded on a [`Tape`], collected in a [`OpSegment`], then [`fold`], [`dead`] and [`split`].
//! [`interpret`] says what the operations mean, `Display` prints a segment.

pub mod dead;
pub mod fold;
pub mod interpret;
mod op;
mod print;
pub mod split;
mod tape;

pub use op::{Op, OpId, OpSegment};
pub use tape::{Tape, TapeInt, TapeMask, TapeReal};
