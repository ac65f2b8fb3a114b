//! The ledger of a scene: for each effect whether it is called for, by which node, or what rules it out.

mod book;
mod claim;
mod reach;
mod row;
mod words;

pub use book::Ledger;
pub use row::{Asked, Bytes, Row};
