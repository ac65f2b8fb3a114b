//! What hand-written shaders compute with: mathematics as an author of shaders would write it, or the
//! compiler's, whose results have the bits of the graphs'.
//!
//! A topic is a file: a trait with the functions, as few as shaders call by name, and both ways of computing
//! them. What both compute alike (sums and products, square roots, glam's vectors component by component)
//! needs no function; neither do lengths of way that only decide, such as comparing with 0.

mod boundaries;
mod bumps;
mod colors;
mod directions;
mod flakes;
mod frames;
mod highlights;
mod kinds;
mod lobes;
mod noises;
mod numbers;
mod patterns;
mod whole;

pub use boundaries::Boundaries;
pub use bumps::Bumps;
pub use colors::Colors;
pub use directions::Directions;
pub use flakes::Flakes;
pub use frames::{Frame, Frames};
pub use highlights::Highlights;
pub use kinds::{SameBits, Std};
pub use lobes::{Facing, Lobes};
pub use noises::Noises;
pub use numbers::{Numbers, Value};
pub use patterns::Patterns;
pub use whole::Arithmetic;
