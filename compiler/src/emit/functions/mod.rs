//! Functions composed of [`Real`](super::Real) operations: what node bodies call.

pub mod conventions;
pub mod placing;
