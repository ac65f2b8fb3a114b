//! The engines: walk, batch and jit, behind one trait that hand-written shaders share.

mod evaluations;
pub mod execute;
pub mod jit;
mod links;
mod memory;
mod options;
mod requests;
mod runner;
mod shade;
mod shader;
mod turns;
pub mod walk;

pub use evaluations::Evaluations;
pub use links::Links;
pub use options::{Engine, Options, Simd};
pub use runner::Runner;
pub use shade::{Shade, Shaded};
pub use shader::{Shader, ShaderError};
