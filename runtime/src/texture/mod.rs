//! Textures: pictures that shaders read by surface coordinates.

mod library;
mod picture;

pub use library::{TEXTURE_PIXEL_LIMIT, TextureError, Textures, unusable};
pub use picture::Picture;
