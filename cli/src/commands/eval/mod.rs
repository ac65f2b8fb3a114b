//! `phenomenon eval`.

mod command;
mod point;
mod state_fields;
mod values;

pub use command::{Arguments, run};
