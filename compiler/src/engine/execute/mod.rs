//! Runs a schedule over a batch of points: the one executor batch and jit share. They differ in how
//! a segment is run.

mod asks;
mod loops;
mod memory;
mod run;
mod tally;

pub use memory::{Memory, UniformWords, WordsId};
pub use run::Program;
