//! Random keys, sub-pixel positions and positions on lights: functions of what is sampled, never of a sequence.

mod hash;
mod light;
mod pixel;

pub use hash::{child_path, mixed, path_key};
pub use light::light_position;
pub use pixel::pixel_position;
