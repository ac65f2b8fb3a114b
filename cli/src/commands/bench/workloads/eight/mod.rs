//! Two workloads by hand for AVX2: what somebody who knows the machine writes, with functions of his own
//! that are as accurate as those of the project and know none of its conventions for NaN and infinity.

mod functions;
mod mixed;
mod shade;
mod ten;
mod vector;

pub use shade::{mixed, ten};
