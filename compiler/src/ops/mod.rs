//! The scalar operations of a pure segment: what the JIT fuses, and the passes that prepare them.
//!
//! Declared in one table (`table.rs`), recorded on a [`Tape`], collected in a [`OpSegment`], then [`legalise`],
//! [`fold`], [`dead`] and [`split`]. [`apply`] evaluates them over any back end, [`interpret`] says what they
//! mean, `Display` prints a segment, [`verify`] says what holds of one after each pass.

#[macro_use]
mod table;

pub mod apply;
pub mod dead;
pub mod evaluate;
pub mod fold;
pub mod hoist;
mod index;
pub mod interpret;
pub mod legalise;
mod op;
mod print;
pub mod split;
mod tape;
pub mod verify;

pub use op::{Class, Number, Op, OpId, OpSegment};
pub use tape::{Tape, TapeInputs, TapeInt, TapeMask, TapeReal};
