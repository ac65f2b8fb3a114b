//! The attributes of an OpenEXR file.
//!
//! Layout: "OpenEXR File Layout", openexr.com.

use std::io::{self, Read};

use super::channels::{Channel, Selection, select};
use crate::film::buffer::pixel_count;
use crate::film::fault::Fault;
use crate::film::header::{Channels, Format, PictureHeader, array, skip};

/// Most parts of an OpenEXR file.
pub const PART_LIMIT: usize = 1 << 10;

/// Most channels of a part of an OpenEXR file.
pub const CHANNEL_LIMIT: usize = 1 << 10;

/// Most chunks of pixels in an OpenEXR file.
pub const CHUNK_LIMIT: u64 = 1 << 20;

/// Most bytes of the pixels of one chunk of an OpenEXR file.
pub const CHUNK_BYTES_LIMIT: u64 = 1 << 29;

/// A rectangle of pixels, ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Window {
    pub(super) left: i32,
    pub(super) top: i32,
    right: i32,
    bottom: i32,
}

/// One picture of a file.
#[derive(Debug, Default)]
pub(super) struct Part {
    pub(super) name: String,
    pub(super) channels: Vec<Channel>,
    data: Option<Window>,
    display: Option<Window>,
    tile: Option<[u32; 2]>,
    compression: Option<u8>,
    kind: String,
}

/// What a file says before its chunks.
#[derive(Debug)]
pub(in crate::film) struct Header {
    /// Which part is read, and which channels of it.
    pub(super) part: usize,
    pub(super) selection: Selection,
    pub(super) data: Window,
    pub(super) display: Window,
    /// Most bytes of the pixels of one chunk of the file.
    pub(super) chunk_bytes: u64,
    width: u32,
    height: u32,
}

impl Window {
    fn read(read: &mut impl Read) -> Result<Self, Fault> {
        let mut side = || Ok::<_, Fault>(i32::from_le_bytes(array(read)?));
        Ok(Window { left: side()?, top: side()?, right: side()?, bottom: side()? })
    }

    /// Width and height, within the limits of pictures.
    fn size(self, what: &str) -> Result<(u32, u32), Fault> {
        // Two 32-bit corners may be 2^32 apart.
        let side =
            |low: i32, high: i32| (i64::from(high) - i64::from(low) + 1).min(u32::MAX.into());
        let sides = [side(self.left, self.right), side(self.top, self.bottom)];
        let [Ok(width @ 1..), Ok(height @ 1..)] = sides.map(u32::try_from) else {
            return Err(Fault::Malformed(format!("its {what} window has no pixels")));
        };
        pixel_count(width, height)?;
        Ok((width, height))
    }
}

impl Header {
    pub(in crate::film) fn summary(&self) -> PictureHeader {
        let channels = match (self.selection.grey, self.selection.alpha.is_some()) {
            (true, false) => Channels::Grey,
            (true, true) => Channels::GreyAlpha,
            (false, false) => Channels::Color,
            (false, true) => Channels::ColorAlpha,
        };
        PictureHeader { format: Format::Exr, width: self.width, height: self.height, channels }
    }
}

/// Reads up to the chunk tables, where the magic number has been read.
pub(in crate::film) fn read_header(read: &mut impl Read) -> Result<Header, Fault> {
    let version = u32::from_le_bytes(array(read)?);
    let flag = |bit: u32| version & (1 << bit) != 0;
    if version & 0xff != 2 || version >> 13 != 0 {
        return Err(Fault::malformed("only version 2 of the format is read"));
    }
    let mut parts = Vec::new();
    loop {
        match part(read)? {
            None if !parts.is_empty() => break,
            None => return Err(Fault::malformed("it has no parts")),
            Some(_) if parts.len() == PART_LIMIT => {
                return Err(Fault::Malformed(format!("it has more than {PART_LIMIT} parts")));
            }
            Some(part) => parts.push(part),
        }
        if !flag(12) {
            break;
        }
    }
    if flag(11) || parts.iter().any(|part| part.kind.starts_with("deep")) {
        return Err(Fault::malformed("its pixels are deep data, which is not read: flatten it"));
    }
    let (mut chunks, mut chunk_bytes) = (0, 0);
    for part in &parts {
        let (count, bytes) = part.chunks(flag(9))?;
        chunks += count;
        chunk_bytes = bytes.max(chunk_bytes);
    }
    if chunks > CHUNK_LIMIT {
        return Err(Fault::Malformed(format!(
            "its pixels are in {chunks} chunks, and at most {CHUNK_LIMIT} are read: write it with larger tiles"
        )));
    }
    let (part, selection) = select(&parts)?;
    let (Some(data), Some(display)) = (parts[part].data, parts[part].display) else {
        return Err(missing("displayWindow"));
    };
    let (width, height) = display.size("display")?;
    Ok(Header { part, selection, data, display, chunk_bytes, width, height })
}

fn missing(attribute: &str) -> Fault {
    Fault::Malformed(format!("a part has no attribute `{attribute}`"))
}

/// The attributes of a part; none at the end of the parts.
fn part(read: &mut impl Read) -> Result<Option<Part>, Fault> {
    let mut part = Part::default();
    let mut empty = true;
    loop {
        let name = text(read)?;
        if name.is_empty() {
            return Ok((!empty).then_some(part));
        }
        empty = false;
        let kind = text(read)?;
        let size = u64::try_from(i32::from_le_bytes(array(read)?));
        let size =
            size.map_err(|_| Fault::Malformed(format!("the size of `{name}` is negative")))?;
        let mut value = read.by_ref().take(size);
        let value = &mut value;
        match (name.as_str(), kind.as_str()) {
            ("channels", "chlist") => part.channels = channels(value)?,
            ("dataWindow", "box2i") => part.data = Some(Window::read(value)?),
            ("displayWindow", "box2i") => part.display = Some(Window::read(value)?),
            ("compression", "compression") => part.compression = Some(array::<1>(value)?[0]),
            ("tiles", "tiledesc") => {
                let mut side = || Ok::<_, Fault>(u32::from_le_bytes(array(value)?));
                part.tile = Some([side()?, side()?]);
            }
            ("name", "string") => part.name = whole_text(value)?,
            ("type", "string") => part.kind = whole_text(value)?,
            _ => {}
        }
        let rest = value.limit();
        skip(value, rest)?;
    }
}

fn channels(read: &mut impl Read) -> Result<Vec<Channel>, Fault> {
    let mut channels = Vec::new();
    loop {
        let name = text(read)?;
        if name.is_empty() {
            return Ok(channels);
        }
        if channels.len() == CHANNEL_LIMIT {
            return Err(Fault::Malformed(format!("it has more than {CHANNEL_LIMIT} channels")));
        }
        let kind = i32::from_le_bytes(array(read)?);
        let bytes = match kind {
            0 | 2 => 4,
            1 => 2,
            _ => return Err(Fault::Malformed(format!("channel `{name}` is of no known type"))),
        };
        let _linear_and_reserved: [u8; 4] = array(read)?;
        let mut step = || Ok::<_, Fault>(i32::from_le_bytes(array(read)?));
        channels.push(Channel { name, bytes, subsampled: [step()?, step()?] != [1, 1] });
    }
}

/// A text that ends with 0.
fn text(read: &mut impl Read) -> Result<String, Fault> {
    let mut bytes = Vec::new();
    loop {
        match array(read)? {
            [0] => return Ok(String::from_utf8_lossy(&bytes).into_owned()),
            _ if bytes.len() == 255 => return Err(Fault::malformed("a name is too long")),
            [byte] => bytes.push(byte),
        }
    }
}

/// A text that is all of an attribute.
fn whole_text(read: &mut io::Take<impl Read>) -> Result<String, Fault> {
    let mut bytes = Vec::new();
    read.take(1024).read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

impl Part {
    /// How many chunks there are, and how many bytes the pixels of the largest have.
    fn chunks(&self, tiled: bool) -> Result<(u64, u64), Fault> {
        let data = self.data.ok_or_else(|| missing("dataWindow"))?;
        let (width, height) = data.size("data")?;
        let pixel: u64 = self.channels.iter().map(|channel| channel.bytes).sum();
        let [tile_width, tile_height] = match (tiled || self.kind == "tiledimage", self.tile) {
            (false, _) => [width, lines(self.compression.ok_or_else(|| missing("compression"))?)],
            (true, Some([0, _] | [_, 0])) => {
                return Err(Fault::malformed("its tiles have no pixels"));
            }
            (true, Some(tile)) => tile,
            (true, None) => return Err(missing("tiles")),
        };
        let bytes = u64::from(tile_width).saturating_mul(tile_height.into()).saturating_mul(pixel);
        if bytes > CHUNK_BYTES_LIMIT {
            return Err(Fault::Malformed(format!(
                "a chunk of its pixels has {bytes} bytes, and at most {CHUNK_BYTES_LIMIT} are read: write it with fewer channels or smaller tiles"
            )));
        }
        let count = |length: u32, side: u32| u64::from(length.div_ceil(side));
        let chunks = count(width, tile_width) * count(height, tile_height);
        Ok((chunks, bytes))
    }
}

/// Lines in a chunk of this compression.
fn lines(compression: u8) -> u32 {
    match compression {
        // None, run lengths, ZIPS.
        0..=2 => 1,
        // ZIP, PXR24.
        3 | 5 => 16,
        // PIZ, B44, B44A, DWAA.
        4 | 6..=8 => 32,
        // DWAB.
        _ => 256,
    }
}
