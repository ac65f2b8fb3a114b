//! How a word is named and where it lies: what the program's text and its engines agree on.

mod lanes;

pub use lanes::{FileShape, LANES, Lanes, Placement, Source, stride};
