//! `phenomenon bench`.

mod column;
mod command;
mod compile;
mod contender;
mod generators;
mod render;
mod results;
mod shade;
mod statistics;
mod workloads;

pub use command::{Arguments, run};
