//! `phenomenon effects`.

mod command;
mod human;
mod json;
mod measured;

pub use command::{Arguments, run};
