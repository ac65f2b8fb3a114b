//! Pictures: made, written, read and compared.

mod alpha;
mod buffer;
mod bytes;
mod compare;
mod encoding;
mod fault;
mod file;
mod header;
mod open_exr;
mod radiance;
mod raster;

pub use buffer::{Film, PIXEL_LIMIT, SIDE_LIMIT, SizeError};
pub use compare::{CompareError, Comparison, Difference, NotFinite, compare, difference_picture};
pub use encoding::{srgb_decoded, srgb_encoded};
pub use fault::FilmError;
pub use file::{check_format, encode, read, read_as, write};
pub use header::{
    Channels, FILE_BYTES_LIMIT, Format, HEADER_BYTES_LIMIT, PictureHeader, read_header,
};
pub use open_exr::{CHANNEL_LIMIT, CHUNK_BYTES_LIMIT, CHUNK_LIMIT, PART_LIMIT};
pub use raster::DECODER_BYTES_LIMIT;
