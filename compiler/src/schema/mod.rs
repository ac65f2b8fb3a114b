//! What is known about files, for editors and for reference pages: the JSON Schema of graphs, made from
//! the list of nodes, and tables of keys, from which schemas, pages and readers of other files are made.

mod graph;
mod key;
mod parts;
mod tables;

pub use graph::define_graph;
pub use key::{Given, Key, Kind, Section};
pub use parts::{object, reference};
pub use tables::with_tables;
