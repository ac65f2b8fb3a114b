//! Reads, checks, compiles and evaluates shader graphs.

pub mod check;
pub mod diagnostics;
pub mod document;
pub mod effects;
pub mod emit;
pub mod engine;
pub mod graph;
pub mod nodes;
pub mod ops;
pub mod schedule;
pub mod specialise;
pub mod state;
