//! What the conformance tests share: random graphs and states, a renderer that answers a hash of each
//! request, an evaluator that follows the definition word for word, and the comparison of engines.

pub mod build;
pub mod differential;
pub mod mock;
pub mod naive;
pub mod print;
pub mod random;
pub mod random_graph;
pub mod reads;
pub mod scopes;
pub mod shrink;
