//! Random keys and sub-pixel positions: functions of what is sampled, never of a sequence.

mod hash;
mod pixel;

pub use hash::{child_path, mixed, path_key};
pub use pixel::pixel_position;
