//! Formats of picture files, and what their headers say.

use std::fmt;
use std::path::Path;

/// A format of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Portable network graphics.
    Png,
    /// JPEG.
    Jpeg,
    /// OpenEXR.
    Exr,
    /// Radiance's RGBE.
    Hdr,
}

impl Format {
    pub(super) const ALL: [Format; 4] = [Format::Png, Format::Jpeg, Format::Exr, Format::Hdr];

    /// The format that the ending of a file's name names.
    pub fn of(path: &Path) -> Option<Format> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "png" => Some(Format::Png),
            "jpg" | "jpeg" => Some(Format::Jpeg),
            "exr" => Some(Format::Exr),
            "hdr" => Some(Format::Hdr),
            _ => None,
        }
    }

    /// The bytes that files of this format begin with.
    pub(super) fn signature(self) -> &'static [u8] {
        match self {
            Format::Png => b"\x89PNG\r\n\x1a\n",
            Format::Jpeg => b"\xff\xd8",
            Format::Exr => b"\x76\x2f\x31\x01",
            Format::Hdr => b"#?",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Format::Png => "PNG",
            Format::Jpeg => "JPEG",
            Format::Exr => "OpenEXR",
            Format::Hdr => "Radiance HDR",
        })
    }
}

/// Which numbers a pixel has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channels {
    /// One: equal red, green and blue.
    Grey,
    /// A grey and alpha.
    GreyAlpha,
    /// Red, green and blue.
    Color,
    /// Red, green, blue and alpha.
    ColorAlpha,
}

impl fmt::Display for Channels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Channels::Grey => "grey",
            Channels::GreyAlpha => "grey with alpha",
            Channels::Color => "color",
            Channels::ColorAlpha => "color with alpha",
        })
    }
}

/// What the header of a picture says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureHeader {
    /// The format, by the file's ending.
    pub format: Format,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Which numbers a pixel has. A transparent colour of a PNG is not seen here.
    pub channels: Channels,
}

impl fmt::Display for PictureHeader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { format, width, height, channels } = self;
        write!(f, "{format}, {width} x {height}, {channels}")
    }
}
