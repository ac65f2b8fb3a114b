//! PNG and JPEG: pictures of 8 or 16 bits a channel, which the crate `image` decodes.

use std::io::{BufRead, Seek, Write};

use image::codecs::{jpeg::JpegDecoder, png::PngDecoder, png::PngEncoder};
use image::{ColorType, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError, Limits};

use super::alpha::{associated, straight};
use super::buffer::Film;
use super::encoding::{srgb_byte, srgb_decoded};
use super::fault::Fault;
use super::format::{Format, PictureHeader};
use super::size::{SizeError, room_for};

/// Most bytes a decoder may take beside the pixels: for a line, and for each of what is said about the
/// picture.
pub const DECODER_BYTES_LIMIT: u64 = 1 << 26;

/// What a JPEG decoder holds of each channel of a pixel where the picture comes in several passes.
const COEFFICIENT_BYTES: u64 = 2;

/// Most channels of a JPEG.
const JPEG_CHANNELS: u64 = 4;

/// Reads a picture from the start of its file, after its header was found good. Alpha is straight in these
/// formats and becomes associated.
pub(super) fn read(
    header: &PictureHeader,
    encoded: bool,
    file: impl BufRead + Seek,
) -> Result<Film, Fault> {
    let mut limits = Limits::default();
    limits.max_image_width = Some(header.width);
    limits.max_image_height = Some(header.height);
    limits.max_alloc = Some(DECODER_BYTES_LIMIT);
    let fault = |error| fault(error, header);
    if header.format == Format::Png {
        return decode(header, encoded, PngDecoder::with_limits(file, limits).map_err(fault)?);
    }
    let pixels = u64::from(header.width) * u64::from(header.height);
    room_for(
        pixels * COEFFICIENT_BYTES * JPEG_CHANNELS + DECODER_BYTES_LIMIT,
        (header.width, header.height),
    )?;
    let mut decoder = JpegDecoder::new(file).map_err(fault)?;
    limits.max_alloc = None;
    decoder.set_limits(limits).map_err(fault)?;
    decode(header, encoded, decoder)
}

fn decode(
    header: &PictureHeader,
    encoded: bool,
    decoder: impl ImageDecoder,
) -> Result<Film, Fault> {
    let (width, height) = (header.width, header.height);
    if decoder.dimensions() != (width, height) {
        return Err(Fault::malformed("it gives its size twice, and not the same"));
    }
    let mut film = Film::new(width, height)?;
    let color = decoder.color_type();
    let mut bytes = Vec::new();
    let memory = || SizeError::Memory { width, height };
    let count = usize::try_from(decoder.total_bytes()).map_err(|_| memory())?;
    bytes.try_reserve_exact(count).map_err(|_| memory())?;
    bytes.resize(count, 0);
    decoder.read_image(&mut bytes).map_err(|error| fault(error, header))?;
    let deep =
        matches!(color, ColorType::L16 | ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16);
    let channels = usize::from(color.channel_count());
    let pixels = bytes.chunks_exact(usize::from(color.bytes_per_pixel()));
    for (pixel, bytes) in film.pixels_mut().iter_mut().zip(pixels) {
        let value = |channel: usize| match deep {
            true => {
                f32::from(u16::from_ne_bytes([bytes[2 * channel], bytes[2 * channel + 1]]))
                    / f32::from(u16::MAX)
            }
            false => f32::from(bytes[channel]) / f32::from(u8::MAX),
        };
        let (color, alpha) = match channels {
            1 => ([value(0); 3], 1.0),
            2 => ([value(0); 3], value(1)),
            3 => ([value(0), value(1), value(2)], 1.0),
            _ => ([value(0), value(1), value(2)], value(3)),
        };
        let color = if encoded { color.map(srgb_decoded) } else { color };
        *pixel = associated(color, alpha);
    }
    Ok(film)
}

/// Writes a PNG of 8 bits a channel, sRGB-encoded, its colours multiplied by `exposure` first. It has
/// an alpha channel, straight as the format asks, where a pixel is not opaque.
pub(super) fn write_png(film: &Film, exposure: f32, to: &mut impl Write) -> Result<(), Fault> {
    let (width, height) = (film.width(), film.height());
    let opaque = film.pixels().iter().all(|pixel| alpha_byte(pixel[3]) == u8::MAX);
    let channels = if opaque { 3 } else { 4 };
    let mut samples = Vec::new();
    samples
        .try_reserve_exact(film.pixels().len() * channels)
        .map_err(|_| SizeError::Memory { width, height })?;
    for pixel in film.pixels() {
        let color = if opaque { [pixel[0], pixel[1], pixel[2]] } else { straight(*pixel) };
        samples.extend(color.map(|x| srgb_byte(x * exposure)));
        if !opaque {
            samples.push(alpha_byte(pixel[3]));
        }
    }
    let color = if opaque { ExtendedColorType::Rgb8 } else { ExtendedColorType::Rgba8 };
    PngEncoder::new(to).write_image(&samples, width, height, color).map_err(|error| match error {
        ImageError::IoError(error) => Fault::System(error),
        other => Fault::Malformed(other.to_string()),
    })
}

/// Alpha in 8 bits, rounded to nearest; NaN becomes 0.
fn alpha_byte(alpha: f32) -> u8 {
    (alpha * 255.0 + 0.5) as u8
}

/// What the decoder says, in our terms.
fn fault(error: ImageError, header: &PictureHeader) -> Fault {
    let (width, height) = (header.width, header.height);
    match error {
        ImageError::IoError(error) if error.kind() == std::io::ErrorKind::OutOfMemory => {
            SizeError::Memory { width, height }.into()
        }
        ImageError::IoError(error) => error.into(),
        ImageError::Limits(_) => Fault::Malformed(format!(
            "what it says about its picture, such as color profiles and texts, has more than {DECODER_BYTES_LIMIT} bytes"
        )),
        other => Fault::Malformed(other.to_string()),
    }
}
