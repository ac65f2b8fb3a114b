//! The eight materials of the thesis in `bench shade`: each at points of the default scene, whose effects are
//! answered from a table that was recorded before.

mod listening;
mod material;
mod recorded;
mod recording;
mod table;

pub use material::{Material, Stage};
pub use recorded::Recorded;
