//! `phenomenon bench shade`.

mod column;
mod command;
mod contender;
mod laziness;
mod materials;
mod points;
mod race;
mod subject;
mod tables;

pub use command::{Arguments, run};
