//! OpenEXR pictures.
//!
//! The header is read here, so that nothing is taken on trust when the pixels are decoded: what is past
//! the limits, or of a kind that is not read, is refused with its reason.

mod channels;
mod header;
mod part;
mod read;
mod write;

pub(super) use header::read_header;
pub use header::{CHUNK_LIMIT, PART_LIMIT};
pub use part::{CHANNEL_LIMIT, CHUNK_BYTES_LIMIT};
pub(super) use read::read;
pub(super) use write::write;
