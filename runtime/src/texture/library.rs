//! The textures of a scene, each file opened once.

use std::collections::BTreeMap;
use std::path::Path;

use phenomenon_compiler::effects::{Lookup, Sampling, TextureId};
use phenomenon_compiler::engine::Shade;
use phenomenon_compiler::values::{Space, Texture, TilePattern, TilesError};

use super::tiles::Tiles;
use super::{Picture, levels};
use crate::film::{self, FilmError, SizeError};

/// Why a texture cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TextureError {
    /// The file cannot be read as a picture.
    #[error(transparent)]
    File(#[from] FilmError),
    /// It is a set of tiles, and there are none.
    #[error("{file}: {error}")]
    Tiles {
        /// The pattern.
        file: String,
        /// Why.
        error: TilesError,
    },
    /// There is not enough memory for coarser versions of the picture.
    #[error(transparent)]
    Levels(#[from] SizeError),
    /// A pixel is infinite or NaN.
    #[error("{file}: pixel {column}, {row} is not finite")]
    NotFinite {
        /// The file.
        file: String,
        /// From the left.
        column: u32,
        /// From the top.
        row: u32,
    },
    /// All textures together are too large.
    #[error(
        "{file}: with it all textures have {pixels} pixels, coarser versions for footprints included, and at \
         most {limit} are read: make some smaller"
    )]
    TooManyPixels {
        /// The file that is too much.
        file: String,
        /// Of it and all before.
        pixels: u64,
        /// Most there may be.
        limit: u64,
    },
}

/// Most pixels of all textures of a scene: 4 GiB of memory.
pub const TEXTURE_PIXEL_LIMIT: u64 = 1 << 28;

/// Bytes of a pixel in memory.
const PIXEL_BYTES: u64 = size_of::<[f32; 4]>() as u64;

/// Why a picture cannot be a texture; none where it can. It is decoded for that, and not kept.
pub fn unusable(path: &Path) -> Option<TextureError> {
    let file = path.display().to_string();
    let space = Space::of_file(&file);
    Textures::default().open(&Texture { file, space }).err()
}

/// How many pixels textures have together.
#[derive(Debug)]
pub struct PixelSum {
    pixels: u64,
    limit: u64,
}

impl Default for PixelSum {
    /// None yet, and [`TEXTURE_PIXEL_LIMIT`].
    fn default() -> Self {
        Self { pixels: 0, limit: TEXTURE_PIXEL_LIMIT }
    }
}

impl PixelSum {
    /// Adds those of a picture of this size.
    ///
    /// # Errors
    /// They are too many with those before.
    pub fn add(&mut self, file: &str, [width, height]: [u32; 2]) -> Result<(), TextureError> {
        self.add_pixels(file, u64::from(width) * u64::from(height))
    }

    /// Adds those of the coarser versions of a picture of this size.
    ///
    /// # Errors
    /// They are too many with those before.
    pub fn add_levels(&mut self, file: &str, size: [u32; 2]) -> Result<(), TextureError> {
        self.add_pixels(file, levels::pixels(size))
    }

    fn add_pixels(&mut self, file: &str, pixels: u64) -> Result<(), TextureError> {
        let (pixels, limit) = (self.pixels.saturating_add(pixels), self.limit);
        if pixels > limit {
            return Err(TextureError::TooManyPixels { file: file.to_owned(), pixels, limit });
        }
        self.pixels = pixels;
        Ok(())
    }
}

/// Textures by number.
#[derive(Debug, Default)]
pub struct Textures {
    numbers: BTreeMap<Texture, TextureId>,
    opened: Vec<Opened>,
    sum: PixelSum,
}

/// What a texture is.
#[derive(Debug)]
enum Opened {
    Picture(Picture),
    Tiles(Tiles),
}

impl Opened {
    /// Its pixels, and those of its coarser versions.
    fn pixels(&self) -> [u64; 2] {
        let of = |size: [u32; 2], has_levels: bool| {
            let coarser = if has_levels { levels::pixels(size) } else { 0 };
            [u64::from(size[0]) * u64::from(size[1]), coarser]
        };
        match self {
            Opened::Picture(picture) => of(picture.size(), picture.has_levels()),
            Opened::Tiles(tiles) => tiles.sizes().fold([0, 0], |sum, (size, has_levels)| {
                let [pixels, coarser] = of(size, has_levels);
                [sum[0] + pixels, sum[1] + coarser]
            }),
        }
    }
}

impl Textures {
    /// Opens a texture, unless it is open already.
    ///
    /// # Errors
    /// The file is no picture, holds numbers that are not finite, or is too much with those before.
    pub fn open(&mut self, texture: &Texture) -> Result<(), TextureError> {
        if self.numbers.contains_key(texture) {
            return Ok(());
        }
        let opened = match TilePattern::of(Path::new(&texture.file)) {
            None => Opened::Picture(self.read_file(&texture.file, texture.space)?),
            Some(pattern) => {
                let missing = |error| TextureError::Tiles { file: texture.file.clone(), error };
                let mut tiles = Tiles::default();
                for (tile, path) in pattern.files().map_err(missing)? {
                    let picture = self.read_file(&path.display().to_string(), texture.space)?;
                    tiles.add(tile, picture);
                }
                Opened::Tiles(tiles)
            }
        };
        self.numbers.insert(texture.clone(), TextureId(self.opened.len() as u32));
        self.opened.push(opened);
        Ok(())
    }

    fn read_file(&mut self, file: &str, space: Space) -> Result<Picture, TextureError> {
        let path = Path::new(file);
        let header = film::read_header(path)?;
        self.sum.add(file, [header.width, header.height])?;
        let film = film::read_as(path, Some(space))?;
        let width = film.width() as usize;
        let bad = film.pixels().iter().position(|pixel| !pixel.iter().all(|x| x.is_finite()));
        if let Some(at) = bad {
            let (column, row) = ((at % width) as u32, (at / width) as u32);
            return Err(TextureError::NotFinite { file: file.to_owned(), column, row });
        }
        Ok(Picture::new(film))
    }

    /// Opens all that a shader may read, and makes those ready for footprints that are read by them.
    ///
    /// # Errors
    /// As for [`Textures::open`].
    pub fn open_those_of(&mut self, shader: &dyn Shade) -> Result<(), TextureError> {
        shader.textures().iter().try_for_each(|texture| self.open(texture))?;
        shader.filtered_textures().iter().try_for_each(|texture| self.make_levels(texture))
    }

    /// Makes the coarser versions of a texture that was opened, unless there are any.
    fn make_levels(&mut self, texture: &Texture) -> Result<(), TextureError> {
        let number = self.number(texture);
        match self.opened.get_mut(number.0 as usize) {
            Some(Opened::Picture(picture)) if !picture.has_levels() => {
                self.sum.add_levels(&texture.file, picture.size())?;
                picture.make_levels()?;
            }
            Some(Opened::Tiles(tiles)) => {
                for size in tiles.sizes_without_levels() {
                    self.sum.add_levels(&texture.file, size)?;
                }
                tiles.make_levels()?;
            }
            Some(Opened::Picture(_)) | None => {}
        }
        Ok(())
    }

    /// Makes the coarser versions of all that are open.
    ///
    /// # Errors
    /// They are too much.
    pub fn make_all_levels(&mut self) -> Result<(), TextureError> {
        let textures: Vec<Texture> = self.numbers.keys().cloned().collect();
        textures.iter().try_for_each(|texture| self.make_levels(texture))
    }

    /// The textures that are open, by number, with the bytes of their pixels, and those of their coarser versions.
    pub fn opened(&self) -> impl Iterator<Item = (&Texture, u64, u64)> {
        let mut textures: Vec<(&Texture, TextureId)> =
            self.numbers.iter().map(|(texture, number)| (texture, *number)).collect();
        textures.sort_by_key(|(_, number)| number.0);
        textures.into_iter().map(|(texture, number)| {
            let [pixels, coarser] = self.opened[number.0 as usize].pixels();
            (texture, pixels * PIXEL_BYTES, coarser * PIXEL_BYTES)
        })
    }

    /// Columns and rows of a texture; of tiles, those of the first.
    pub fn size(&self, texture: TextureId) -> Option<[u32; 2]> {
        match self.opened.get(texture.0 as usize)? {
            Opened::Picture(picture) => Some(picture.size()),
            Opened::Tiles(tiles) => tiles.size(),
        }
    }

    /// The number of a texture; that of none where it was not opened.
    pub fn number(&self, texture: &Texture) -> TextureId {
        self.numbers.get(texture).copied().unwrap_or(TextureId(u32::MAX))
    }

    /// The picture of a number; none where it is not there, or is made of tiles.
    pub fn picture(&self, texture: TextureId) -> Option<&Picture> {
        match self.opened.get(texture.0 as usize)? {
            Opened::Picture(picture) => Some(picture),
            Opened::Tiles(_) => None,
        }
    }

    /// The colour of a texture at each place, as shaders are answered; none where there is none.
    pub fn read(
        &self,
        texture: TextureId,
        sampling: Sampling,
        lookups: &[Lookup],
        colors: &mut [Option<[f32; 4]>],
    ) {
        let opened = self.opened.get(texture.0 as usize);
        for (lookup, color) in lookups.iter().zip(colors) {
            *color = match opened {
                Some(Opened::Picture(picture)) => picture.color(sampling, lookup),
                Some(Opened::Tiles(tiles)) => tiles.color(sampling, lookup),
                None => None,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Film;

    #[test]
    fn a_file_is_opened_once_for_each_space() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("grey.png");
        let mut film = Film::new(1, 1).unwrap();
        film.set(0, 0, [0.214_041_14, 0.214_041_14, 0.214_041_14, 1.0]);
        film::write(&film, &path, 1.0).unwrap();
        let texture = |space| Texture { file: path.display().to_string(), space };
        let mut textures = Textures::default();
        for space in [Space::Srgb, Space::Linear, Space::Srgb] {
            textures.open(&texture(space)).unwrap();
        }
        assert_eq!(textures.opened.len(), 2);
        let red = |space| {
            let picture = textures.picture(textures.number(&texture(space))).unwrap();
            let middle = Lookup { uv: [0.5, 0.5], ..Lookup::default() };
            picture.color(Sampling::default(), &middle).unwrap()[0]
        };
        // Half of sRGB is 0.214 of the light, to the precision of 8 bits.
        assert!((red(Space::Srgb) - 0.214).abs() < 2e-3, "{}", red(Space::Srgb));
        assert!((red(Space::Linear) - 0.5).abs() < 4e-3, "{}", red(Space::Linear));
        let other = Texture { file: "other.png".into(), space: Space::Srgb };
        assert!(textures.picture(textures.number(&other)).is_none());
    }

    /// None yet; all that are opened have at most so many pixels.
    fn limited_to(limit: u64) -> Textures {
        Textures { sum: PixelSum { pixels: 0, limit }, ..Textures::default() }
    }

    #[test]
    fn all_textures_together_have_a_limit() {
        let folder = tempfile::tempdir().unwrap();
        let texture = |name: &str, width: u32| {
            let path = folder.path().join(name);
            film::write(&Film::new(width, 2).unwrap(), &path, 1.0).unwrap();
            Texture { file: path.display().to_string(), space: Space::Srgb }
        };
        let (first, second) = (texture("first.png", 3), texture("second.png", 1));
        let mut textures = limited_to(7);
        textures.open(&first).unwrap();
        // What is open already is not counted again.
        textures.open(&first).unwrap();
        let error = textures.open(&second).unwrap_err().to_string();
        assert!(error.contains("second.png: with it all textures have 8 pixels"), "{error}");
        assert!(textures.picture(textures.number(&second)).is_none());
        let mut textures = limited_to(8);
        textures.open(&second).unwrap();
        textures.open(&first).unwrap();
        // A picture of 1 by 2 has a coarser version of one pixel, made and counted once.
        let error = textures.make_levels(&second).unwrap_err().to_string();
        assert!(error.contains("second.png: with it all textures have 9 pixels"), "{error}");
        let mut textures = limited_to(3);
        textures.open(&second).unwrap();
        for _ in 0..2 {
            textures.make_levels(&second).unwrap();
        }
    }

    #[test]
    fn tiles_are_opened_and_counted_together() {
        let folder = tempfile::tempdir().unwrap();
        for (name, width) in [("a.1001.png", 3), ("a.1003.png", 1), ("a.1001.exr", 50)] {
            film::write(&Film::new(width, 2).unwrap(), &folder.path().join(name), 1.0).unwrap();
        }
        let file = folder.path().join("a.<UDIM>.png").display().to_string();
        let texture = Texture { file, space: Space::Linear };
        let error = limited_to(7).open(&texture).unwrap_err().to_string();
        assert!(error.contains("a.1003.png: with it all textures have 8 pixels"), "{error}");
        // Coarser versions: of 3 by 2 one pixel, of 1 by 2 another.
        let mut textures = limited_to(10);
        textures.open(&texture).unwrap();
        for _ in 0..2 {
            textures.make_levels(&texture).unwrap();
        }
        assert_eq!(textures.sum.pixels, 10);
        let number = textures.number(&texture);
        assert_eq!(textures.size(number), Some([3, 2]));
        let mut colors = [None; 3];
        let lookups =
            [[0.5, 0.5], [1.5, 0.5], [2.5, 0.5]].map(|uv| Lookup { uv, ..Lookup::default() });
        textures.read(number, Sampling::default(), &lookups, &mut colors);
        assert_eq!(colors.map(|color| color.is_some()), [true, false, true]);
        let none = folder.path().join("b.<UDIM>.png").display().to_string();
        let none = Texture { file: none, space: Space::Linear };
        let error = textures.open(&none).unwrap_err().to_string();
        assert!(error.contains("b.<UDIM>.png: ") && error.contains("`b.1001.png`"), "{error}");
        assert_eq!(textures.size(textures.number(&none)), None);
    }

    #[test]
    fn what_is_no_picture_of_finite_numbers_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bad.exr");
        let mut film = Film::new(2, 2).unwrap();
        film.set(1, 0, [f32::NAN, 0.0, 0.0, 1.0]);
        film::write(&film, &path, 1.0).unwrap();
        let mut textures = Textures::default();
        let texture = Texture { file: path.display().to_string(), space: Space::Linear };
        let error = textures.open(&texture).unwrap_err().to_string();
        assert!(error.ends_with("pixel 1, 0 is not finite"), "{error}");
        let missing = Texture { file: "no_such.png".into(), space: Space::Srgb };
        assert!(textures.open(&missing).unwrap_err().to_string().contains("no_such.png"));
    }
}
