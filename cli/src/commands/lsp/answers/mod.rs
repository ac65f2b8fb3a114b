//! What the server answers to requests about an open file, a file a request.

mod actions;
mod colors;
mod definition;
mod formatting;
mod links;
mod references;
mod rename;
mod symbols;
mod tokens;

pub use actions::actions;
pub use colors::{colors, presentations};
pub use definition::definition;
pub use formatting::formatting;
pub use links::links;
pub use references::{highlights, references};
pub use rename::{prepare, rename};
pub use symbols::symbols;
pub use tokens::{LEGEND, tokens};
