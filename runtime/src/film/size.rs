//! How large pictures and their files may be.

/// Most pixels along a side of a film.
pub const SIDE_LIMIT: u32 = 1 << 16;

/// Most pixels of a film: 1 GiB of memory.
pub const PIXEL_LIMIT: u64 = 1 << 26;

/// Most bytes of a picture that is read.
pub const FILE_BYTES_LIMIT: u64 = 1 << 31;

/// Most bytes of what a file says before its pixels.
pub const HEADER_BYTES_LIMIT: u64 = 1 << 24;

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
pub(super) fn room_for(bytes: u64, (width, height): (u32, u32)) -> Result<(), SizeError> {
    let room =
        usize::try_from(bytes).is_ok_and(|bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok());
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
            assert_eq!(pixel_count(width, height), Err(SizeError::Limit { width, height }));
        }
    }
}
