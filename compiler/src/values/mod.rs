//! What graphs hold: types, literals and pictures. Every other room speaks these words.

mod literal;
mod name;
mod texture;
mod types;

pub use literal::Literal;
pub use name::Name;
pub use texture::{Space, Texture};
pub use types::Type;
