//! Machine code by Cranelift: for every CPU it knows vectors of, four lanes at a time.

mod code;
mod lower;

pub use code::CraneliftCode;
