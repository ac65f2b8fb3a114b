//! The tree walk: one point at a time, inputs evaluated when a body demands them, each result kept
//! until its epoch is passed anew. What mi_eval and its cache do, and the oracle of the other
//! engines.

mod asks;
mod code;
mod loops;
mod memory;
mod run;

pub use code::Code;
pub use memory::Memory;
