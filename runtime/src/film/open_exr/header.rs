//! What an OpenEXR file says before its pixels.
//!
//! Layout: "OpenEXR File Layout", openexr.com.

use std::io::Read;

use super::channels::{Selection, select};
use super::part::{Window, missing, part};
use crate::film::fault::Fault;
use crate::film::format::{Channels, Format, PictureHeader};
use crate::film::input::array;

/// Most parts of an OpenEXR file.
pub const PART_LIMIT: usize = 1 << 10;

/// Most chunks of pixels in an OpenEXR file.
pub const CHUNK_LIMIT: u64 = 1 << 20;

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
