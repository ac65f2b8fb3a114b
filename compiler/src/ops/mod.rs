//! The scalar operations of a pure segment: what the JIT fuses.

mod tape;

pub use tape::{Op, OpId, Tape, TapeInt, TapeMask, TapeReal};
