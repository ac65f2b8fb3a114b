//! The shipped phenomena written by hand, as an expert would in Rust: what composing a shader from
//! nodes is measured against.
//!
//! They take one point after the other, and ask the renderer for the same rays under the same conditions
//! as the graphs, at the sites of the graphs' nodes: so random numbers are the same. A body is written once
//! and computes in two ways ([`arithmetic`]): with glam and std's mathematics results agree to within
//! rounding, with the compiler's to the bit.

mod advanced_glass;
mod aniso_brdf;
pub mod arithmetic;
mod asking;
mod cd;
mod checker_floor;
mod constant_simple;
mod gradient_sky;
mod identity;
mod library;
mod of_graph;
mod optics;
mod pointwise;
mod rainbow;
mod silk;
mod site;
mod snow;
mod strata;
mod sunglasses;
mod tinted_mirror;
mod xray;

pub use advanced_glass::AdvancedGlass;
pub use aniso_brdf::AnisoBrdf;
pub use asking::{Asking, Light};
pub use cd::Cd;
pub use checker_floor::CheckerFloor;
pub use constant_simple::ConstantSimple;
pub use gradient_sky::GradientSky;
pub use identity::{NotWrittenByHand, graph_by_hand, recognise};
pub use library::{MonolithError, NAMES, find, find_same_bits};
pub use of_graph::{NoMonolith, of_graph};
pub use pointwise::{Parameter, PointShader, Pointwise};
pub use rainbow::Rainbow;
pub use silk::Silk;
pub use site::Site;
pub use snow::Snow;
pub use sunglasses::Sunglasses;
pub use tinted_mirror::TintedMirror;
pub use xray::Xray;
