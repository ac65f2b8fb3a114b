//! `phenomenon check`: everything that is wrong in graphs and scenes.

mod command;
mod mend;

pub use command::{Arguments, run};
