//! `--size WxH`.

use phenomenon_runtime::film::{PIXEL_LIMIT, SIDE_LIMIT};

use super::numbers::count;

/// Width and height of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
}

/// Reads `--size`.
pub fn size(text: &str) -> Result<Size, String> {
    let remedy = format!("write width x height, each 1 to {SIDE_LIMIT}, such as 512x512");
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(|| remedy.clone())?;
    if text.contains(char::is_whitespace) {
        return Err(remedy);
    }
    let side = |text: &str| match count(text, 0..=SIDE_LIMIT, "a side") {
        Ok(0) => Err(format!("a picture without pixels; {remedy}")),
        side => side.map_err(|_| remedy.clone()),
    };
    let size = Size { width: side(width)?, height: side(height)? };
    let pixels = u64::from(size.width) * u64::from(size.height);
    if pixels > PIXEL_LIMIT {
        return Err(format!("{pixels} pixels are more than {PIXEL_LIMIT}; {remedy}"));
    }
    Ok(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read() {
        assert_eq!(size("512x256"), Ok(Size { width: 512, height: 256 }));
        assert_eq!(size("1e2x4.0"), Ok(Size { width: 100, height: 4 }));
        assert_eq!(size("1X1"), Ok(Size { width: 1, height: 1 }));
    }

    #[test]
    fn what_is_no_size_is_refused_with_a_remedy() {
        for text in [
            "",
            "x",
            "512",
            "0x0",
            "0x9",
            "9x0",
            "1e9x4",
            "-1x4",
            "4x4x4",
            "4294967297x1",
            "65537x1",
            "NaNxNaN",
            "32768x32768",
            " 4x4",
            "+4x4",
            "04x4",
            "4x0x4",
            "4.5x4",
        ] {
            let error = size(text).expect_err(text);
            assert!(error.contains("512x512"), "{text}: {error}");
        }
    }
}
