//! `phenomenon bench compile`.

mod command;
mod layers;
mod turn;

pub use command::{Arguments, run};
