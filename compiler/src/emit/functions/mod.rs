//! Functions composed of [`Real`](super::Real) operations: what node bodies call.

pub mod colors;
pub mod conventions;
pub mod frames;
pub mod placing;
pub mod rotation;
pub mod shaping;
