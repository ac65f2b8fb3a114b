//! Textures: pictures that shaders read by surface coordinates.

mod library;
mod picture;

pub use library::{TextureError, Textures};
pub use picture::Picture;
