//! Values of flags, each refused with a message that says what would do.

mod allowance;
mod assignment;
mod choices;
mod numbers;
mod output;
mod region;
mod size;
mod synonyms;

pub use allowance::allowable;
pub use assignment::assignment;
pub use choices::{EngineChoice, Format, GeneratorChoice, Precision, SimdChoice};
pub use numbers::{
    batch, exposure, nodes, rays, runs, samples, seed, threads, tolerance, with_dashed_numbers,
};
pub use output::picture;
pub use region::region;
pub use size::{Size, size};
pub use synonyms::explained;
