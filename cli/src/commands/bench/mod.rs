//! `phenomenon bench`.

mod command;
mod contender;
mod render;
mod results;
mod shade;
mod statistics;
mod workloads;

pub use command::{Arguments, run};
