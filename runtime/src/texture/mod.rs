//! Textures: pictures that shaders read by surface coordinates.

mod decoded;
mod footprint;
mod levels;
mod library;
mod picture;
mod tiles;
mod wrap;

pub use decoded::DecodedPictures;
pub use library::{PixelSum, TEXTURE_PIXEL_LIMIT, TextureError, Textures, unusable};
pub use picture::Picture;
