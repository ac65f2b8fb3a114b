//! A picture in memory.

use super::header::PictureHeader;

/// Most pixels along a side of a film.
pub const SIDE_LIMIT: u32 = 1 << 16;

/// Most pixels of a film: 1 GiB of memory.
pub const PIXEL_LIMIT: u64 = 1 << 26;

/// Scene-linear colours (Rec. 709 primaries) with associated alpha, in rows from the top left: red, green
/// and blue are what is seen over black, alpha is how much of what lies behind is covered. A colour
/// above its alpha is one that also shines.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    pixels: Vec<[f32; 4]>,
}

/// A film cannot have this size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SizeError {
    /// There can never be one.
    #[error(
        "a picture of {width} x {height} pixels is not possible: each side takes 1 to {SIDE_LIMIT} pixels, and all of it at most {PIXEL_LIMIT}"
    )]
    Limit {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// There is not enough memory now.
    #[error("not enough memory for a picture of {width} x {height} pixels")]
    Memory {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
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

/// How many pixels a film of this size has.
///
/// # Errors
/// It is past the limits.
pub(super) fn pixel_count(width: u32, height: u32) -> Result<usize, SizeError> {
    let pixels = u64::from(width) * u64::from(height);
    let sides = (1..=SIDE_LIMIT).contains(&width) && (1..=SIDE_LIMIT).contains(&height);
    match sides && pixels <= PIXEL_LIMIT {
        true => Ok(pixels as usize),
        false => Err(SizeError::Limit { width, height }),
    }
}

/// Fails where so many bytes cannot be had now: asked before a library takes them, which would end
/// the program.
pub(super) fn room_for(bytes: u64, header: &PictureHeader) -> Result<(), SizeError> {
    let room =
        usize::try_from(bytes).is_ok_and(|bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok());
    let (width, height) = (header.width, header.height);
    if room { Ok(()) } else { Err(SizeError::Memory { width, height }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_are_the_last_sizes_there_are() {
        for (width, height) in [(1, 1), (SIDE_LIMIT, 1), (1, SIDE_LIMIT), (8192, 8192)] {
            assert!(pixel_count(width, height).is_ok(), "{width} x {height}");
        }
        for (width, height) in
            [(0, 1), (1, 0), (SIDE_LIMIT + 1, 1), (1, u32::MAX), (8192, 8193), (u32::MAX, u32::MAX)]
        {
            assert_eq!(Film::new(width, height), Err(SizeError::Limit { width, height }));
        }
    }
}
