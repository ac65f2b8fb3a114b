//! Files, made byte by byte.

use std::path::PathBuf;

use phenomenon_runtime::film::{Film, read, read_header};
use tempfile::TempDir;

/// A folder for the files of a test.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

/// The picture of a file with these bytes.
pub fn picture(name: &str, bytes: &[u8]) -> Film {
    let folder = Folder::new();
    let path = folder.file(name, bytes);
    let film = read(&path).unwrap();
    let header = read_header(&path).unwrap();
    assert_eq!((header.width, header.height), (film.width(), film.height()));
    film
}

/// What is said of a file with these bytes, which is no usable picture.
pub fn refused(name: &str, bytes: &[u8]) -> String {
    let folder = Folder::new();
    read(&folder.file(name, bytes)).unwrap_err().to_string()
}

/// The same where the header alone must show it.
pub fn refused_by_header(name: &str, bytes: &[u8]) -> String {
    let folder = Folder::new();
    let path = folder.file(name, bytes);
    let said = read_header(&path).unwrap_err().to_string();
    assert_eq!(read(&path).unwrap_err().to_string(), said);
    said
}

/// A PNG with these chunks between its header and its pixels: each row of `rows` begins with its
/// filter.
pub fn png(
    [width, height]: [u32; 2],
    [depth, color]: [u8; 2],
    chunks: &[(&[u8; 4], Vec<u8>)],
    rows: &[u8],
) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = [width.to_be_bytes(), height.to_be_bytes()].concat();
    header.extend([depth, color, 0, 0, 0]);
    chunk(&mut bytes, b"IHDR", &header);
    for (kind, data) in chunks {
        chunk(&mut bytes, kind, data);
    }
    chunk(&mut bytes, b"IDAT", &stored(rows));
    chunk(&mut bytes, b"IEND", &[]);
    bytes
}

fn chunk(bytes: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    bytes.extend((data.len() as u32).to_be_bytes());
    let start = bytes.len();
    bytes.extend(kind);
    bytes.extend(data);
    let mut crc = u32::MAX;
    for byte in &bytes[start..] {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 0 { crc >> 1 } else { (crc >> 1) ^ 0xedb8_8320 };
        }
    }
    bytes.extend((!crc).to_be_bytes());
}

/// A zlib stream without compression (RFC 1950, RFC 1951).
fn stored(data: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0x78, 0x01];
    let mut blocks = data.chunks(0xffff).peekable();
    while let Some(block) = blocks.next() {
        bytes.push(u8::from(blocks.peek().is_none()));
        let length = block.len() as u16;
        bytes.extend(length.to_le_bytes());
        bytes.extend((!length).to_le_bytes());
        bytes.extend(block);
    }
    let (mut a, mut b) = (1_u32, 0_u32);
    for byte in data {
        a = (a + u32::from(*byte)) % 65_521;
        b = (b + a) % 65_521;
    }
    bytes.extend((b << 16 | a).to_be_bytes());
    bytes
}

/// A zlib stream of so many zeros: 13 bits for each 258.
pub fn zeros(count: u64) -> Vec<u8> {
    let (mut bytes, mut bits, mut used) = (vec![0x78, 0x01], 0_u32, 0);
    let mut put = |value: u32, length: u32| {
        bits |= value << used;
        used += length;
        while used >= 8 {
            bytes.push(bits as u8);
            bits >>= 8;
            used -= 8;
        }
    };
    // The last block, of fixed codes; Huffman codes come with their first bit first.
    put(0b011, 3);
    put(0b0000_1100, 8);
    let runs = (count - 1) / 258;
    for _ in 0..runs {
        put(0b1010_0011, 8);
        put(0, 5);
    }
    for _ in 0..count - 1 - runs * 258 {
        put(0b0000_1100, 8);
    }
    put(0, 7);
    put(0, 7);
    bytes.extend(((count % 65_521) as u32 * 0x1_0000 + 1).to_be_bytes());
    bytes
}

/// An OpenEXR part without compression.
#[derive(Clone)]
pub struct Part {
    /// Names, and types: 0 whole numbers, 1 half, 2 float.
    pub channels: Vec<(&'static str, i32)>,
    /// Left, top, right and bottom, ends included.
    pub data: [i32; 4],
    pub display: [i32; 4],
    /// Side of its tiles.
    pub tile: Option<u32>,
    pub name: &'static str,
    /// Of a channel, by its number, at a column and row.
    pub value: fn(usize, i32, i32) -> f64,
    /// Samples of all channels are taken at every so many pixels.
    pub sampling: i32,
}

impl Part {
    pub fn new(channels: &[(&'static str, i32)], window: [i32; 4]) -> Self {
        Self {
            channels: channels.to_vec(),
            data: window,
            display: window,
            tile: None,
            name: "",
            value: |channel, x, y| f64::from(x) + 0.25 * f64::from(y) + 8.0 * channel as f64,
            sampling: 1,
        }
    }

    fn header(&self, several: bool) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut channels = Vec::new();
        for (name, kind) in &self.channels {
            channels.extend(name.as_bytes());
            channels.push(0);
            channels.extend(kind.to_le_bytes());
            channels.extend([0; 4]);
            channels.extend([self.sampling.to_le_bytes(); 2].concat());
        }
        channels.push(0);
        let window = |window: [i32; 4]| window.map(i32::to_le_bytes).concat();
        attribute(&mut bytes, "channels", "chlist", &channels);
        attribute(&mut bytes, "compression", "compression", &[0]);
        attribute(&mut bytes, "dataWindow", "box2i", &window(self.data));
        attribute(&mut bytes, "displayWindow", "box2i", &window(self.display));
        attribute(&mut bytes, "lineOrder", "lineOrder", &[0]);
        attribute(&mut bytes, "pixelAspectRatio", "float", &1.0_f32.to_le_bytes());
        attribute(&mut bytes, "screenWindowCenter", "v2f", &[0; 8]);
        attribute(&mut bytes, "screenWindowWidth", "float", &1.0_f32.to_le_bytes());
        if let Some(side) = self.tile {
            let mut tiles = [side.to_le_bytes(); 2].concat();
            tiles.push(0);
            attribute(&mut bytes, "tiles", "tiledesc", &tiles);
        }
        if several {
            attribute(&mut bytes, "name", "string", self.name.as_bytes());
            let kind = if self.tile.is_some() { "tiledimage" } else { "scanlineimage" };
            attribute(&mut bytes, "type", "string", kind.as_bytes());
            let count = self.chunks().len() as i32;
            attribute(&mut bytes, "chunkCount", "int", &count.to_le_bytes());
        }
        bytes.push(0);
        bytes
    }

    fn chunks(&self) -> Vec<Vec<u8>> {
        let [left, top, right, bottom] = self.data;
        let mut chunks = Vec::new();
        match self.tile.map(|side| side as i32) {
            None => {
                for y in top..=bottom {
                    let pixels = self.pixels([left, y, right, y]);
                    let mut chunk = y.to_le_bytes().to_vec();
                    chunk.extend((pixels.len() as i32).to_le_bytes());
                    chunks.push([chunk, pixels].concat());
                }
            }
            Some(side) => {
                for (row, y) in (top..=bottom).step_by(side as usize).enumerate() {
                    for (column, x) in (left..=right).step_by(side as usize).enumerate() {
                        let end = [(x + side - 1).min(right), (y + side - 1).min(bottom)];
                        let pixels = self.pixels([x, y, end[0], end[1]]);
                        let place = [column as i32, row as i32, 0, 0, pixels.len() as i32];
                        chunks.push([place.map(i32::to_le_bytes).concat(), pixels].concat());
                    }
                }
            }
        }
        chunks
    }

    fn pixels(&self, [left, top, right, bottom]: [i32; 4]) -> Vec<u8> {
        let mut bytes = Vec::new();
        for y in top..=bottom {
            for (channel, (_, kind)) in self.channels.iter().enumerate() {
                for x in left..=right {
                    let value = (self.value)(channel, x, y);
                    match kind {
                        0 => bytes.extend((value as u32).to_le_bytes()),
                        1 => bytes.extend(exr::prelude::f16::from_f64(value).to_le_bytes()),
                        _ => bytes.extend((value as f32).to_le_bytes()),
                    }
                }
            }
        }
        bytes
    }
}

pub fn attribute(bytes: &mut Vec<u8>, name: &str, kind: &str, value: &[u8]) {
    for text in [name, kind] {
        bytes.extend(text.as_bytes());
        bytes.push(0);
    }
    bytes.extend((value.len() as i32).to_le_bytes());
    bytes.extend(value);
}

/// An OpenEXR file of these parts, and where its chunk tables begin.
pub fn open_exr_with_tables(parts: &[Part]) -> (Vec<u8>, usize) {
    let several = parts.len() > 1;
    let tiled = !several && parts[0].tile.is_some();
    let flags = u32::from(tiled) << 9 | u32::from(several) << 12;
    let mut bytes = [20_000_630_u32.to_le_bytes(), (2 | flags).to_le_bytes()].concat();
    for part in parts {
        bytes.extend(part.header(several));
    }
    if several {
        bytes.push(0);
    }
    let tables = bytes.len();
    let count: usize = parts.iter().map(|part| part.chunks().len()).sum();
    let mut at = tables + 8 * count;
    let (mut table, mut pixels) = (Vec::new(), Vec::new());
    for (number, part) in parts.iter().enumerate() {
        for mut chunk in part.chunks() {
            if several {
                chunk.splice(0..0, (number as i32).to_le_bytes());
            }
            table.extend((at as u64).to_le_bytes());
            at += chunk.len();
            pixels.extend(chunk);
        }
    }
    ([bytes, table, pixels].concat(), tables)
}

pub fn open_exr(parts: &[Part]) -> Vec<u8> {
    open_exr_with_tables(parts).0
}
