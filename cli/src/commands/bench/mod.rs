//! `phenomenon bench`.

mod command;
mod compile;
mod generators;
mod render;
mod results;
mod shade;
mod statistics;
mod workloads;

pub use command::{Arguments, run};
