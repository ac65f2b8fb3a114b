//! Scenes with their materials compiled: what `render` renders.

mod changes;
mod flags;
mod load;
mod refused;

pub use flags::Flags;
pub use load::{Picture, load};
