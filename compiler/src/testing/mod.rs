//! What the tests of nodes share, for crates that have nodes of their own: what every node must keep to,
//! random graphs and states, a renderer that answers a hash of each request, an evaluator that follows
//! the definition word for word, and the comparison of engines. [`test_nodes!`](crate::test_nodes) runs
//! all of it on the nodes of a library.

pub mod build;
pub mod differential;
pub mod engines;
pub mod forms;
pub mod mock;
pub mod naive;
pub mod print;
pub mod random;
pub mod random_graph;
pub mod reads;
pub mod sets;
pub mod shrink;
pub mod signatures;
mod subjects;
mod suite;
mod trial;

pub use subjects::Subjects;
