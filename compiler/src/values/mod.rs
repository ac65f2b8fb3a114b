//! What graphs hold: types, literals, pictures and spaces of colours. Every other room speaks these words.

mod color_space;
mod literal;
mod name;
mod texture;
mod tiles;
mod types;

pub use color_space::ColorSpace;
pub use literal::Literal;
pub use name::Name;
pub use texture::{Space, Texture};
pub use tiles::{Tile, TilePattern, TilesError};
pub use types::Type;
