//! Picture files.

use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use exr::prelude::{
    Blocks, Compression, Encoding, Image, Layer, LayerAttributes, LineOrder, SpecificChannels,
    Vec2, WritableImage,
};

use phenomenon_compiler::document::open_file;
use phenomenon_compiler::nodes::Space;

use super::buffer::{Film, SizeError};
use super::encoding::{srgb_byte, srgb_decoded};
use crate::outputs::{self, WriteError};

/// Why a picture could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// The file's ending names no format.
    #[error("{}: the ending must be .png, .exr or .hdr", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// It cannot be written.
    #[error(transparent)]
    Unwritable(#[from] WriteError),
    /// It cannot be read.
    #[error("cannot read {path}: {source}", path = path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// It is not a picture of its format, or too large for it.
    #[error("{path} is not a usable picture: {message}", path = path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What the decoder says.
        message: String,
    },
    /// Its size is not possible.
    #[error("{path}: {source}", path = path.display())]
    Size {
        /// The file.
        path: PathBuf,
        /// Which size.
        source: SizeError,
    },
}

#[derive(Clone, Copy)]
enum Format {
    Png,
    Exr,
    Hdr,
}

fn format(path: &Path) -> Result<Format, FilmError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("png") => Ok(Format::Png),
        Some("exr") => Ok(Format::Exr),
        Some("hdr") => Ok(Format::Hdr),
        _ => Err(FilmError::UnknownFormat { path: path.to_owned() }),
    }
}

fn picture_format(path: &Path) -> Result<image::ImageFormat, FilmError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    if matches!(ending.as_deref(), Some("jpg" | "jpeg")) {
        return Ok(image::ImageFormat::Jpeg);
    }
    Ok(match format(path)? {
        Format::Png => image::ImageFormat::Png,
        Format::Exr => image::ImageFormat::OpenExr,
        Format::Hdr => image::ImageFormat::Hdr,
    })
}

/// Checks that [`write()`] knows the file's ending, before hours are spent on a picture.
pub fn check_format(path: &Path) -> Result<(), FilmError> {
    format(path).map(|_| ())
}

/// Writes a picture as [`encode`] makes it, whole or not at all.
pub fn write(film: &Film, path: &Path, exposure: f32) -> Result<(), FilmError> {
    Ok(outputs::write(path, &encode(film, path, exposure)?)?)
}

/// The bytes of a picture in the format of its file's ending. PNG is sRGB-encoded in 8 bits without
/// alpha, after every colour is multiplied by `exposure` (a factor; 1 changes nothing). EXR (f32,
/// with alpha) and HDR (shared exponent, without alpha) keep the scene-linear values as they are.
/// The same picture gives the same bytes.
pub fn encode(film: &Film, path: &Path, exposure: f32) -> Result<Vec<u8>, FilmError> {
    let malformed = |message: String| FilmError::Malformed { path: path.to_owned(), message };
    match format(path)? {
        Format::Png => png(film, exposure).map_err(|error| malformed(error.to_string())),
        Format::Exr => exr(film).map_err(|error| malformed(error.to_string())),
        Format::Hdr => hdr(film).map_err(|error| malformed(error.to_string())),
    }
}

fn png(film: &Film, exposure: f32) -> image::ImageResult<Vec<u8>> {
    use image::ImageEncoder;
    let rgb = |pixel: &[f32; 4]| [pixel[0], pixel[1], pixel[2]].map(|x| srgb_byte(x * exposure));
    let samples: Vec<u8> = film.pixels().iter().flat_map(rgb).collect();
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes).write_image(
        &samples,
        film.width(),
        film.height(),
        image::ExtendedColorType::Rgb8,
    )?;
    Ok(bytes)
}

fn hdr(film: &Film) -> image::ImageResult<Vec<u8>> {
    let pixels: Vec<_> = film.pixels().iter().map(|&[r, g, b, _]| image::Rgb([r, g, b])).collect();
    let mut bytes = Vec::new();
    image::codecs::hdr::HdrEncoder::new(&mut bytes).encode(
        &pixels,
        film.width() as usize,
        film.height() as usize,
    )?;
    Ok(bytes)
}

fn exr(film: &Film) -> exr::error::Result<Vec<u8>> {
    let pixel = |at: Vec2<usize>| {
        let [r, g, b, a] = film.pixel(at.x() as u32, at.y() as u32);
        (r, g, b, a)
    };
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let layer = Layer::new(
        (film.width() as usize, film.height() as usize),
        LayerAttributes::default(),
        encoding,
        SpecificChannels::rgba(pixel),
    );
    let mut bytes = Vec::new();
    Image::from_layer(layer).write().non_parallel().to_buffered(Cursor::new(&mut bytes))?;
    Ok(bytes)
}

/// Most bytes of a picture that is read.
const FILE_BYTES_LIMIT: u64 = 4 << 30;

/// Reads a picture as scene-linear colours; 8-bit pictures are decoded from sRGB.
pub fn read(path: &Path) -> Result<Film, FilmError> {
    read_as(path, None)
}

/// The same with what its numbers mean, where the caller knows. Besides what is written, JPEG is read.
pub fn read_as(path: &Path, space: Option<Space>) -> Result<Film, FilmError> {
    let format = picture_format(path)?;
    let unreadable = |source| FilmError::Unreadable { path: path.to_owned(), source };
    let (file, size) = open_file(path).map_err(unreadable)?;
    // No picture within the limits of size is as large.
    if size > FILE_BYTES_LIMIT {
        let error = std::io::ErrorKind::FileTooLarge;
        return Err(unreadable(error.into()));
    }
    let mut bytes = Vec::new();
    file.take(FILE_BYTES_LIMIT).read_to_end(&mut bytes).map_err(unreadable)?;
    let malformed = |error: image::ImageError| FilmError::Malformed {
        path: path.to_owned(),
        message: error.to_string(),
    };
    let mut reader = image::ImageReader::with_format(Cursor::new(&bytes), format);
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(4 << 30);
    reader.limits(limits);
    let picture = reader.decode().map_err(malformed)?.into_rgba32f();
    let mut film = Film::new(picture.width(), picture.height())
        .map_err(|source| FilmError::Size { path: path.to_owned(), source })?;
    let encoded = match space {
        Some(space) => space == Space::Srgb,
        None => matches!(format, image::ImageFormat::Png | image::ImageFormat::Jpeg),
    };
    for (column, row, &image::Rgba([r, g, b, a])) in picture.enumerate_pixels() {
        let [r, g, b] = if encoded { [r, g, b].map(srgb_decoded) } else { [r, g, b] };
        film.set(column, row, [r, g, b, a]);
    }
    Ok(film)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film() -> Film {
        let mut film = Film::new(3, 2).unwrap();
        film.set(0, 0, [0.25, 0.5, 1.0, 1.0]);
        film.set(1, 0, [4.0, 1e-3, 0.0, 0.5]);
        film.set(2, 1, [f32::MAX, f32::from_bits(1), -0.0, 0.0]);
        film
    }

    fn in_folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("phenomenon-film-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder.join(name)
    }

    #[test]
    fn exr_keeps_every_bit_and_is_the_same_every_time() {
        let (first, second) = (in_folder("a.exr"), in_folder("b.exr"));
        write(&film(), &first, 1.0).unwrap();
        write(&film(), &second, 3.0).unwrap();
        assert_eq!(std::fs::read(&first).unwrap(), std::fs::read(&second).unwrap());
        assert!(crate::film::compare(&read(&first).unwrap(), &film()).unwrap().identical);
    }

    #[test]
    fn png_encodes_exposes_and_clamps() {
        let path = in_folder("a.png");
        write(&film(), &path, 2.0).unwrap();
        let back = read(&path).unwrap();
        assert!((back.pixel(0, 0)[0] - 0.5).abs() < 4e-3);
        assert_eq!(back.pixel(1, 0)[0], 1.0);
        assert_eq!(back.pixel(2, 1), [1.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn hdr_keeps_eight_bits_of_each_colour() {
        let path = in_folder("a.hdr");
        let mut film = Film::new(9, 2).unwrap();
        film.set(4, 1, [16.0, 8.0, 4.0, 1.0]);
        write(&film, &path, 1.0).unwrap();
        assert_eq!(read(&path).unwrap().pixel(4, 1), [16.0, 8.0, 4.0, 1.0]);
    }

    #[test]
    fn errors_name_the_file() {
        let error = write(&film(), Path::new("/nowhere/a.png"), 1.0).unwrap_err();
        assert!(error.to_string().starts_with("cannot write /nowhere/a.png"), "{error}");
        assert!(matches!(
            write(&film(), Path::new("a.bmp"), 1.0),
            Err(FilmError::UnknownFormat { .. })
        ));
        assert!(matches!(read(Path::new("/nowhere/a.exr")), Err(FilmError::Unreadable { .. })));
        let broken = in_folder("broken.exr");
        std::fs::write(&broken, b"not a picture").unwrap();
        assert!(matches!(read(&broken), Err(FilmError::Malformed { .. })));
    }
}
