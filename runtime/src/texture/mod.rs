//! Textures: pictures that shaders read by surface coordinates.

mod decoded;
mod library;
mod picture;

pub use decoded::DecodedPictures;
pub use library::{PixelSum, TEXTURE_PIXEL_LIMIT, TextureError, Textures, unusable};
pub use picture::Picture;
