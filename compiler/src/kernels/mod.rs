//! Bodies compiled by rustc, their type erased: what the node list holds and the engines call.

mod entries;
mod forms;

pub use entries::{native_simd, scalar, wide, wide_portable};
pub use forms::BodyForms;
