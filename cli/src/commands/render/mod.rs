//! `phenomenon render`.

mod command;
mod cost;
mod named;

pub use command::{Arguments, run};
