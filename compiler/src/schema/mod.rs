//! What editors and reference pages are told of files: the JSON Schema of graphs, made from the list of nodes and the
//! tables of keys, and what is made of the tables of other formats.

mod graph;
mod parts;
mod sections;
mod tables;

pub use graph::define_graph;
pub use parts::{object, reference};
pub use sections::Sections;
pub use tables::with_tables;
