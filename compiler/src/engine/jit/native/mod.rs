//! Machine code for x86-64 with AVX2 and FMA: eight lanes at once, in a pass or two over the operations.
//!
//! Cranelift has no vectors of 256 bits, which is most of what it loses here. A segment is cut into parts of
//! some 80 operations before (see [`crate::ops::split`]), so that simple register allocation does: hardly a
//! word needs a row of its own.

mod assembler;
mod code;
mod constants;
mod function;
mod operations;
mod registers;

pub use code::{MOST_REGISTERS, NativeCode};
