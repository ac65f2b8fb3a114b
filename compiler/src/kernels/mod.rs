//! The forms of bodies, their type erased: what the node list holds and the engines call.
//!
//! Native code is compiled for two of them, one point and eight lanes ([`BodyForms::scalar`] and
//! [`BodyForms::wide`]). All else evaluates what the body recorded once: portable forms for any CPU, sets
//! of values for the checker, tapes for the jit.

mod block;
mod eight;
mod entries;
mod forms;
mod point;
mod recorded;
mod sets;

pub use entries::{NativePoint, native_simd};
pub use forms::BodyForms;
pub use recorded::Recorded;
