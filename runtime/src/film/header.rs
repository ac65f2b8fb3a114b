//! What the header of a picture says, read without the picture.
//!
//! Every picture is looked at this way before anything else: what is past the limits is refused before
//! memory is taken for it, however little its file holds.

use std::fs::File;
use std::io::{BufReader, Read, Take};
use std::path::Path;

use phenomenon_compiler::document::open_file;

use super::fault::{Fault, FilmError};
use super::format::{Channels, Format, PictureHeader};
use super::input::{array, skip};
use super::size::{FILE_BYTES_LIMIT, HEADER_BYTES_LIMIT, pixel_count};
use super::{open_exr, radiance};

/// Reads what the header of a picture says: quickly, whatever its size. What follows may still be
/// damaged.
///
/// # Errors
/// The file cannot be read, or the header shows that it is no picture that is read, or too large.
pub fn read_header(path: &Path) -> Result<PictureHeader, FilmError> {
    let (format, file) = open(path)?;
    read_from(format, BufReader::new(file)).map_err(|fault| fault.of(path))
}

/// Opens a file that may be a picture.
pub(super) fn open(path: &Path) -> Result<(Format, File), FilmError> {
    let format = Format::of(path).ok_or_else(|| FilmError::NoPicture { path: path.to_owned() })?;
    let unreadable = |source| FilmError::Unreadable { path: path.to_owned(), source };
    let (file, bytes) = open_file(path).map_err(unreadable)?;
    match bytes {
        0..=FILE_BYTES_LIMIT => Ok((format, file)),
        _ => Err(FilmError::TooManyBytes { path: path.to_owned(), bytes }),
    }
}

/// Reads a header from the start of a file.
pub(super) fn read_from(format: Format, read: impl Read) -> Result<PictureHeader, Fault> {
    let header = match format {
        Format::Png => parsed(format, read, png),
        Format::Jpeg => parsed(format, read, jpeg),
        Format::Exr => Ok(parsed(format, read, open_exr::read_header)?.summary()),
        Format::Hdr => Ok(parsed(format, read, radiance::read_header)?.summary()),
    }?;
    pixel_count(header.width, header.height)?;
    Ok(header)
}

/// Runs the reader of a header behind the signature of its format, within the limit of bytes.
pub(super) fn parsed<R: Read, T>(
    format: Format,
    read: R,
    parse: impl FnOnce(&mut Take<R>) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let mut read = read.take(HEADER_BYTES_LIMIT);
    let result = signature(format, &mut read).and_then(|()| parse(&mut read));
    result.map_err(|fault| match fault {
        Fault::Malformed(_) if read.limit() == 0 => {
            Fault::Malformed(format!("its header does not end within {HEADER_BYTES_LIMIT} bytes"))
        }
        other => other,
    })
}

/// Reads the first bytes, and says so where they are those of another format.
fn signature(format: Format, read: &mut impl Read) -> Result<(), Fault> {
    let expected = format.signature();
    let mut bytes = [0; 8];
    let mut length = 0;
    while length < expected.len() {
        match read.read(&mut bytes[length..expected.len()])? {
            0 => break,
            more => length += more,
        }
    }
    let found = &bytes[..length];
    if found == expected {
        return Ok(());
    }
    // Signatures are longer or shorter than what was read: those it begins with will do.
    let other = Format::ALL.into_iter().find(|other| {
        let signature = other.signature();
        let common = signature.len().min(length);
        common > 1 && signature[..common] == found[..common]
    });
    Err(Fault::Malformed(match other {
        Some(other) if other != format => format!(
            "by its first bytes it is a picture of format {other}, by its ending one of {format}: rename it"
        ),
        _ if length == 0 => "the file is empty".to_owned(),
        _ => format!("it does not begin as a file of format {format} does"),
    }))
}

fn png(read: &mut impl Read) -> Result<PictureHeader, Fault> {
    let [.., b'I', b'H', b'D', b'R'] = array::<8>(read)? else {
        return Err(Fault::malformed("a PNG begins with the chunk IHDR, and this does not"));
    };
    let (width, height) = (u32::from_be_bytes(array(read)?), u32::from_be_bytes(array(read)?));
    let [_depth, color] = array::<2>(read)?;
    let channels = match color {
        0 => Channels::Grey,
        2 | 3 => Channels::Color,
        4 => Channels::GreyAlpha,
        6 => Channels::ColorAlpha,
        other => return Err(Fault::Malformed(format!("a PNG has no color type {other}"))),
    };
    Ok(PictureHeader { format: Format::Png, width, height, channels })
}

/// Looks for the start of the frame among the segments (ITU-T T.81, B.1.1.3).
fn jpeg(read: &mut impl Read) -> Result<PictureHeader, Fault> {
    loop {
        let marker = jpeg_marker(read)?;
        match marker {
            // Restart markers and TEM stand alone.
            0x01 | 0xd0..=0xd8 => {}
            0xd9 | 0xda => {
                return Err(Fault::malformed(
                    "a JPEG says its size before its pixels, and this does not",
                ));
            }
            0xc0..=0xcf if !matches!(marker, 0xc4 | 0xc8 | 0xcc) => {
                let [_, _, precision, h, i, w, j, components] = array(read)?;
                if precision != 8 {
                    let message = format!("it has {precision} bits a channel; JPEG is read with 8");
                    return Err(Fault::Malformed(message));
                }
                let height = u32::from(u16::from_be_bytes([h, i]));
                let width = u32::from(u16::from_be_bytes([w, j]));
                let channels = if components == 1 { Channels::Grey } else { Channels::Color };
                return Ok(PictureHeader { format: Format::Jpeg, width, height, channels });
            }
            _ => {
                let length = u64::from(u16::from_be_bytes(array(read)?));
                let rest = length.checked_sub(2);
                let rest = rest.ok_or_else(|| Fault::malformed("a segment is too short"))?;
                skip(read, rest)?;
            }
        }
    }
}

/// Looks for the end of a JPEG behind the start of its pixels, where no pixel looks like it: its decoder
/// would fill up what is missing of a file that was cut.
pub(super) fn require_jpeg_end(read: &mut impl Read) -> Result<(), Fault> {
    loop {
        match jpeg_marker(read)? {
            0x01 | 0xd0..=0xd8 => {}
            0xd9 | 0xda => break,
            _ => {
                let length = u64::from(u16::from_be_bytes(array(read)?));
                skip(read, length.saturating_sub(2))?;
            }
        }
    }
    while jpeg_marker(read)? != 0xd9 {}
    Ok(())
}

/// The next marker: 0xff, as often as the writer likes, and what is neither 0xff nor 0.
fn jpeg_marker(read: &mut impl Read) -> Result<u8, Fault> {
    let mut after_ff = false;
    loop {
        let [byte] = array(read)?;
        if after_ff && !matches!(byte, 0 | 0xff) {
            return Ok(byte);
        }
        after_ff = byte == 0xff;
    }
}
