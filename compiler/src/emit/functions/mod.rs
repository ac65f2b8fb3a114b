//! Functions composed of [`Real`](super::Real) operations: what node bodies call.

pub mod bent_normal;
pub mod cells;
pub mod colors;
pub mod conventions;
pub mod distributions;
pub mod facets;
pub mod figures;
pub mod flakes;
pub mod frames;
pub mod gradient_noise;
pub mod hash;
pub mod lobes;
pub mod monotone;
pub mod passage;
pub mod permutation_noise;
pub mod placing;
pub mod reflected;
pub mod rotation;
pub mod shaping;
