//! Picture files.

use std::io::{BufRead, BufReader, Seek};
use std::path::Path;

use phenomenon_compiler::values::Space;

use super::alpha::mapped;
use super::buffer::Film;
use super::bytes::Bytes;
use super::encoding::srgb_decoded;
use super::fault::{Fault, FilmError};
use super::format::Format;
use super::header::{open, parsed, read_from, require_jpeg_end};
use super::size::SizeError;
use super::{open_exr, radiance, raster};
use crate::outputs;

fn written_format(path: &Path) -> Result<Format, FilmError> {
    Format::of(path)
        .filter(|format| *format != Format::Jpeg)
        .ok_or_else(|| FilmError::UnknownFormat { path: path.to_owned() })
}

/// Checks that [`write()`] knows the file's ending, before hours are spent on a picture.
pub fn check_format(path: &Path) -> Result<(), FilmError> {
    written_format(path).map(|_| ())
}

/// Writes a picture as [`encode()`] makes it, whole or not at all.
///
/// # Errors
/// Those of [`encode()`], and the file cannot be written.
pub fn write(film: &Film, path: &Path, exposure: f32) -> Result<(), FilmError> {
    Ok(outputs::write(path, &encode(film, path, exposure)?)?)
}

/// The bytes of a picture in the format of its file's ending. PNG is sRGB-encoded in 8 bits, after every
/// colour is multiplied by `exposure` (a factor; 1 changes nothing), and has straight alpha where the
/// film is not opaque. EXR (f32, with associated alpha) and HDR (shared exponent, without alpha: what is
/// seen over black) keep the scene-linear values. The same picture gives the same bytes.
///
/// # Errors
/// The ending names no format, or there is not enough memory.
pub fn encode(film: &Film, path: &Path, exposure: f32) -> Result<Vec<u8>, FilmError> {
    let format = written_format(path)?;
    let mut bytes = Bytes::default();
    let written = match format {
        Format::Png => raster::write_png(film, exposure, &mut bytes),
        Format::Exr => open_exr::write(film, &mut bytes),
        Format::Hdr => radiance::write(film, &mut bytes).map_err(Fault::System),
        Format::Jpeg => return Err(FilmError::UnknownFormat { path: path.to_owned() }),
    };
    let (width, height) = (film.width(), film.height());
    match written {
        Ok(()) => Ok(bytes.into_inner()),
        // Memory is all that can be wrong with it.
        Err(Fault::System(_)) => Err(Fault::Size(SizeError::Memory { width, height }).of(path)),
        Err(fault) => Err(fault.of(path)),
    }
}

/// Reads a picture as scene-linear colours with associated alpha. PNG and JPEG are decoded from sRGB,
/// whatever profile they carry.
///
/// # Errors
/// The file cannot be read, is no usable picture, or is past the limits.
pub fn read(path: &Path) -> Result<Film, FilmError> {
    read_as(path, None)
}

/// The same with what its numbers mean, where the caller knows.
///
/// # Errors
/// The file cannot be read, is no usable picture, or is past the limits.
pub fn read_as(path: &Path, space: Option<Space>) -> Result<Film, FilmError> {
    let (format, file) = open(path)?;
    decode(format, space, BufReader::new(file)).map_err(|fault| fault.of(path))
}

/// Every header is looked at before any memory is taken for pixels.
fn decode(
    format: Format,
    space: Option<Space>,
    mut file: impl BufRead + Seek,
) -> Result<Film, Fault> {
    let mut film = match format {
        Format::Png | Format::Jpeg => {
            let header = read_from(format, &mut file)?;
            file.rewind()?;
            if format == Format::Jpeg {
                require_jpeg_end(&mut file)?;
                file.rewind()?;
            }
            return raster::read(&header, space != Some(Space::Linear), file);
        }
        Format::Exr => {
            let header = parsed(format, &mut file, open_exr::read_header)?;
            file.rewind()?;
            open_exr::read(&header, file)?
        }
        Format::Hdr => {
            let header = parsed(format, &mut file, radiance::read_header)?;
            radiance::read(&header, &mut file)?
        }
    };
    if space == Some(Space::Srgb) {
        for pixel in film.pixels_mut() {
            *pixel = mapped(*pixel, srgb_decoded);
        }
    }
    Ok(film)
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

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
        // Its straight colour is above white; half of it is covered, in 8 bits.
        assert_eq!(back.pixel(1, 0), [128.0 / 255.0, back.pixel(1, 0)[1], 0.0, 128.0 / 255.0]);
        // What covers nothing is nothing in a format of straight colours.
        assert_eq!(back.pixel(2, 1), [0.0; 4]);
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
        let no_picture = read(Path::new("a.bmp")).unwrap_err().to_string();
        assert!(no_picture.contains(".jpg"), "{no_picture}");
        let broken = in_folder("broken.exr");
        std::fs::write(&broken, b"not a picture").unwrap();
        assert!(matches!(read(&broken), Err(FilmError::Malformed { .. })));
    }
}
