//! Positions in what is specialised.

/// Position in [`Specialised::instances`](super::Specialised::instances).
pub type InstanceId = usize;

/// Position in [`Epochs`](super::Epochs).
pub type EpochId = usize;
