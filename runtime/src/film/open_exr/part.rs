//! The parts of an OpenEXR file: the attributes of each.

use std::io::{self, Read};

use crate::film::fault::Fault;
use crate::film::input::{array, skip};
use crate::film::size::pixel_count;

/// Most channels of a part of an OpenEXR file.
pub const CHANNEL_LIMIT: usize = 1 << 10;

/// Most bytes of the pixels of one chunk of an OpenEXR file.
pub const CHUNK_BYTES_LIMIT: u64 = 1 << 29;

/// A channel of a part.
#[derive(Debug)]
pub(super) struct Channel {
    pub(super) name: String,
    /// Of one sample.
    pub(super) bytes: u64,
    /// It has fewer samples than the picture has pixels.
    pub(super) subsampled: bool,
}

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
    pub(super) data: Option<Window>,
    pub(super) display: Option<Window>,
    tile: Option<[u32; 2]>,
    compression: Option<u8>,
    pub(super) kind: String,
}

impl Window {
    fn read(read: &mut impl Read) -> Result<Self, Fault> {
        let mut side = || Ok::<_, Fault>(i32::from_le_bytes(array(read)?));
        Ok(Window { left: side()?, top: side()?, right: side()?, bottom: side()? })
    }

    /// Width and height, within the limits of pictures.
    pub(super) fn size(self, what: &str) -> Result<(u32, u32), Fault> {
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

/// What is wrong where a part lacks an attribute.
pub(super) fn missing(attribute: &str) -> Fault {
    Fault::Malformed(format!("a part has no attribute `{attribute}`"))
}

/// The attributes of a part; none at the end of the parts.
pub(super) fn part(read: &mut impl Read) -> Result<Option<Part>, Fault> {
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
    pub(super) fn chunks(&self, tiled: bool) -> Result<(u64, u64), Fault> {
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
