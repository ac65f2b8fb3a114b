//! `phenomenon nodes`.

mod command;
mod groups;
mod human;
mod json;
mod search;

pub use command::{Arguments, run};
