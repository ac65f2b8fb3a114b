//! Functions composed of [`Real`](super::Real) operations: what node bodies call.

pub mod cells;
pub mod colors;
pub mod conventions;
pub mod figures;
pub mod flakes;
pub mod frames;
pub mod gradient_noise;
pub mod hash;
pub mod monotone;
pub mod passage;
pub mod permutation_noise;
pub mod placing;
pub mod rotation;
pub mod shaping;
