//! Values of flags, each refused with a message that says what would do.

mod assignment;
mod choices;
mod node_path;
mod numbers;
mod output;
mod size;
mod synonyms;

pub use assignment::{Assignment, assignment};
pub use choices::{EngineChoice, Format, Precision, SimdChoice};
pub use node_path::{NodePath, node_path};
pub use numbers::{batch, exposure, samples, seed, threads, tolerance};
pub use output::picture;
pub use size::{Size, size};
pub use synonyms::explained;
