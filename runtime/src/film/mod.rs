//! Pictures: made, written, read and compared.

mod buffer;
mod compare;
mod encoding;
mod file;

pub use buffer::{Film, PIXEL_LIMIT, SIDE_LIMIT, SizeError};
pub use compare::{Comparison, Difference, SizesDiffer, compare};
pub use encoding::{srgb_decoded, srgb_encoded};
pub use file::{FilmError, check_format, encode, read, read_as, write};
