//! A picture in memory.

/// Most pixels along a side of a film.
pub const SIDE_LIMIT: u32 = 1 << 16;

/// Most pixels of a film: 1 GiB of memory.
pub const PIXEL_LIMIT: u64 = 1 << 26;

/// Scene-linear colours (Rec. 709 primaries) with alpha, in rows from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    pixels: Vec<[f32; 4]>,
}

/// A film cannot have this size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a picture of {width} x {height} pixels is not possible: each side takes 1 to {SIDE_LIMIT} pixels, and all of it at most {PIXEL_LIMIT}"
)]
pub struct SizeError {
    /// Width asked for.
    pub width: u32,
    /// Height asked for.
    pub height: u32,
}

impl Film {
    /// A black, transparent film.
    pub fn new(width: u32, height: u32) -> Result<Self, SizeError> {
        let pixels = u64::from(width) * u64::from(height);
        let sides = (1..=SIDE_LIMIT).contains(&width) && (1..=SIDE_LIMIT).contains(&height);
        if !sides || pixels > PIXEL_LIMIT {
            return Err(SizeError { width, height });
        }
        Ok(Self { width, height, pixels: vec![[0.0; 4]; pixels as usize] })
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
