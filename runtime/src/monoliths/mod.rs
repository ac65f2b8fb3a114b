//! The shipped phenomena written by hand, as an expert would in Rust: what composing a shader from
//! nodes is measured against.
//!
//! They take one point after the other, use glam and std's mathematics, and ask the renderer for
//! the same rays under the same conditions as the graphs. Results agree to within rounding. Their
//! request sites are constants of their own, so random numbers below them differ from the graphs'.

mod advanced_glass;
mod asking;
mod checker_floor;
mod constant_simple;
mod gradient_sky;
mod identity;
mod library;
mod of_graph;
mod optics;
mod pointwise;
mod rainbow;
mod tinted_mirror;

pub use advanced_glass::AdvancedGlass;
pub use checker_floor::CheckerFloor;
pub use constant_simple::ConstantSimple;
pub use gradient_sky::GradientSky;
pub use identity::{NotWrittenByHand, recognise};
pub use library::{MonolithError, NAMES, find};
pub use of_graph::{NoMonolith, of_graph};
pub use pointwise::{Parameter, PointShader, Pointwise};
pub use rainbow::Rainbow;
pub use tinted_mirror::TintedMirror;
