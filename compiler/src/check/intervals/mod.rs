//! What values may be, and what they surely come to be, from literals, parameters and the state
//! through the nodes.
//!
//! Two things are known of a word. Its *set* holds all it may be: node bodies run over intervals
//! ([`crate::emit::interval`]), narrowed by the declared range of the output while all that arrives is
//! in range. From sets follows what can never be: an input whose guard never holds.
//!
//! Sets are too wide to complain of: of `x (1 - x)`, or of the product of two unit vectors, intervals
//! know only bounds that are never met, and a false alarm is worse than silence. So a word also
//! carries what it *reaches*: values it surely takes, found by running the body itself at the ends
//! of what its inputs reach. That is done only where these inputs vary independently: every word
//! carries the sources it depends on (parameters, the state, answers of the renderer), and two words
//! with a source in common are never combined. All complaints rest on what is reached. A parameter
//! without a range, or a point in space, reaches nothing, and nothing is said of what is made of it.

mod arriving;
mod demands;
mod given;
mod pass;
mod slots;
mod trials;
mod value;

pub(super) use pass::Intervals;
pub(super) use value::{Reached, Value, described};
