//! A picture in memory.

use super::size::{SizeError, pixel_count};

/// Scene-linear colours (Rec. 709 primaries) with associated alpha, in rows from the top left: red, green
/// and blue are what is seen over black, alpha is how much of what lies behind is covered. A colour
/// above its alpha is one that also shines.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    pixels: Vec<[f32; 4]>,
}

impl Film {
    /// A black, transparent film.
    ///
    /// # Errors
    /// It is past the limits, or there is not enough memory.
    pub fn new(width: u32, height: u32) -> Result<Self, SizeError> {
        let count = pixel_count(width, height)?;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count).map_err(|_| SizeError::Memory { width, height })?;
        pixels.resize(count, [0.0; 4]);
        Ok(Self { width, height, pixels })
    }

    /// Pixels in a row.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row.
    pub fn pixels(&self) -> &[[f32; 4]] {
        &self.pixels
    }

    /// All pixels, row by row, to be changed.
    pub(super) fn pixels_mut(&mut self) -> &mut [[f32; 4]] {
        &mut self.pixels
    }

    /// The pixel at a column and row inside the film.
    #[inline]
    pub fn pixel(&self, column: u32, row: u32) -> [f32; 4] {
        self.pixels[row as usize * self.width as usize + column as usize]
    }

    /// Sets the pixel at a column and row inside the film.
    #[inline]
    pub fn set(&mut self, column: u32, row: u32, color: [f32; 4]) {
        self.pixels[row as usize * self.width as usize + column as usize] = color;
    }

    /// Replaces what is not finite or negative by 0, as a picture used as a light source needs.
    pub fn without_invalid_light(mut self) -> Self {
        for value in self.pixels.iter_mut().flatten() {
            if !(value.is_finite() && *value >= 0.0) {
                *value = 0.0;
            }
        }
        self
    }
}
