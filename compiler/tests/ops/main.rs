//! The operations of pure segments: their passes, and machine code against the interpreter.

mod folding;
mod hoisting;
mod legalising;
mod machine_code;
mod printing;
mod random;
mod samples;
mod splitting;
mod verifying;
mod wanted;
