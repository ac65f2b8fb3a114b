//! Sets of values instead of values: what a body may yield for any inputs of a box.
//!
//! [`Intervals`] is a back end whose numbers are closed intervals of `f32`, whose integers are
//! intervals of `i32` and whose truth is true, false or open. The operations a node's body records are
//! evaluated on it, so that what the checker proves about a node is proved about the code that runs.
//!
//! It is sound: whatever [`scalar`](super::scalar) computes from inputs within the given sets lies
//! in the sets that come out. Rounding to nearest is monotone, so that a bound computed in `f32` at the ends
//! of the operands holds for all that is between, and nothing needs to be rounded outward; functions aside.
//!
//! Values carry an identity, a hash of how they came about. Two with the same identity are the same
//! value, and `x - x`, `x * x`, `x == x` are then taken for what they are.

mod arithmetic;
mod back_end;
mod functions;
mod identity;
mod number;
mod real;
mod truth;
mod whole;
mod word;

pub use back_end::Intervals;
pub use identity::{derived, tag};
pub use number::Interval;
pub use truth::Truth;
pub use whole::Whole;
pub use word::Word;
