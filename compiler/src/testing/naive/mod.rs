//! The definition of shading, followed word for word and slowly: inputs are evaluated when demanded,
//! each node at most once in each of its epochs. Written from the graph alone, it shares node bodies
//! with the engines and nothing else.

mod evaluation;
mod nodes;
mod requests;
mod shade;
mod surroundings;
mod turns;

pub use nodes::{Naive, TooLong};
