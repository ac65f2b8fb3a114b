//! Radiance's pictures: three mantissas of 8 bits with one exponent.
//!
//! Format: Greg Ward, "Real Pixels", Graphics Gems II; Radiance's manual, "File Formats".

mod header;
mod pixel;
mod read;
mod scanline;
mod write;

pub(super) use header::read_header;
pub(super) use read::read;
pub(super) use write::write;
