//! Pictures: made, written, read and compared.

mod alpha;
mod buffer;
mod bytes;
mod compare;
mod encoding;
mod fault;
mod file;
mod format;
mod header;
mod input;
mod open_exr;
mod radiance;
mod raster;
mod size;

pub use buffer::Film;
pub use compare::{CompareError, Comparison, Difference, NotFinite, compare, difference_picture};
pub use encoding::{srgb_decoded, srgb_encoded};
pub use fault::FilmError;
pub use file::{check_format, encode, read, read_as, write};
pub use format::{Channels, Format, PictureHeader};
pub use header::read_header;
pub use open_exr::{CHANNEL_LIMIT, CHUNK_BYTES_LIMIT, CHUNK_LIMIT, PART_LIMIT};
pub use raster::DECODER_BYTES_LIMIT;
pub use size::{FILE_BYTES_LIMIT, HEADER_BYTES_LIMIT, PIXEL_LIMIT, SIDE_LIMIT, SizeError};
