//! Files that promise much, hold little, or are damaged.

use std::fs::File;
use std::path::Path;

use phenomenon_runtime::film::{
    CHANNEL_LIMIT, DECODER_BYTES_LIMIT, Film, FilmError, HEADER_BYTES_LIMIT, compare, encode, read,
    read_header,
};

use crate::files::{
    Folder, Part, attribute, open_exr, open_exr_with_tables, png, refused, refused_by_header, zeros,
};

const COLOR: [(&str, i32); 3] = [("B", 2), ("G", 2), ("R", 2)];

/// The start of a JPEG with a frame of this size, after these segments.
fn jpeg(width: u16, height: u16, before: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0xff, 0xd8];
    bytes.extend(before);
    bytes.extend([0xff, 0xc0, 0, 17, 8]);
    bytes.extend(height.to_be_bytes());
    bytes.extend(width.to_be_bytes());
    bytes.extend([3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0]);
    bytes
}

#[test]
fn giants_are_refused_by_their_headers() {
    for (width, height) in [
        (u32::MAX, u32::MAX),
        (0x7fff_ffff, 1),
        (1, 65_537),
        (65_536, 1_025),
        (30_000, 30_000),
        (0, 1),
        (1, 0),
    ] {
        for kind in [0, 2, 3, 6] {
            let said = refused_by_header("a.png", &png([width, height], [8, kind], &[], &[0]));
            assert!(said.contains(&format!("{width} x {height}")), "{said}");
        }
    }
    for (width, height) in [(65_535, 65_535), (0, 9), (9, 0), (8_193, 8_192)] {
        let said = refused_by_header("a.jpg", &jpeg(width, height, &[]));
        assert!(said.contains(&format!("{width} x {height}")), "{said}");
    }
    let hdr = |resolution: &str| format!("#?RGBE\n\n{resolution}\n");
    for resolution in ["-Y 4294967295 +X 4294967295", "+X 8192 -Y 8193", "-Y 65537 +X 1"] {
        let said = refused_by_header("a.hdr", hdr(resolution).as_bytes());
        assert!(said.contains("is not possible"), "{said}");
    }
}

#[test]
fn giant_windows_tiles_and_tables_are_refused_by_their_headers() {
    let with = |change: fn(&mut Part)| {
        let mut part = Part::new(&COLOR, [0, 0, 3, 2]);
        change(&mut part);
        // The header alone; its pixels are never made.
        part.tile = part.tile.or(Some(16));
        let mut header = [20_000_630_u32.to_le_bytes(), 0x202_u32.to_le_bytes()].concat();
        header.extend(header_of(&part));
        refused_by_header("a.exr", &header)
    };
    for (said, part) in [
        (with(|part| part.data = [0, 0, i32::MAX, i32::MAX]), "2147483648 x 2147483648"),
        (with(|part| part.data = [i32::MIN, 0, i32::MAX, 0]), "4294967295 x 1"),
        (with(|part| part.data = [0, 0, 65_536, 0]), "65537 x 1"),
        (with(|part| part.data = [5, 5, 4, 9]), "no pixels"),
        (with(|part| part.data = [5, 5, -4, 9]), "no pixels"),
        (with(|part| part.display = [-60_000, -60_000, -1, -1]), "60000 x 60000"),
        (with(|part| part.display = [0, 0, -2, -2]), "no pixels"),
        (with(|part| part.tile = Some(0)), "tiles have no pixels"),
        (with(|part| part.tile = Some(u32::MAX)), "a chunk of its pixels"),
        (with(|part| part.tile = Some(1 << 13)), "a chunk of its pixels"),
        (with(|part| (part.tile, part.data) = (Some(1), [0, 0, 8_191, 8_191])), "67108864 chunks"),
        (with(|part| part.channels = vec![("Y", 7)]), "no known type"),
        (with(|part| part.channels = vec![("Y", 2); CHANNEL_LIMIT + 1]), "channels"),
    ] {
        assert!(said.contains(part), "lacks `{part}`: {said}");
    }
}

/// The attributes of a part that has tiles, without its pixels.
fn header_of(part: &Part) -> Vec<u8> {
    let mut small = part.clone();
    (small.data, small.tile) = ([0; 4], Some(1));
    if part.channels.iter().any(|(_, kind)| *kind > 2) {
        small.channels = part.channels.clone();
    }
    let (bytes, tables) = open_exr_with_tables(&[small]);
    let mut header = bytes[8..tables - 1].to_vec();
    // The last attribute of a name counts.
    attribute(&mut header, "dataWindow", "box2i", &part.data.map(i32::to_le_bytes).concat());
    let side = part.tile.unwrap_or(1).to_le_bytes();
    attribute(&mut header, "tiles", "tiledesc", &[&side[..], &side, &[0]].concat());
    header.push(0);
    header
}

#[test]
fn what_is_said_about_a_picture_is_bounded() {
    let folder = Folder::new();
    // 70 million zeros in half a megabyte: texts are never unpacked, profiles not past the limit.
    for chunk in [
        (b"zTXt", [b"a\0\0".to_vec(), zeros(70_000_000)].concat()),
        (b"iTXt", [b"a\0\x01\0\0\0".to_vec(), zeros(70_000_000)].concat()),
        (b"iCCP", [b"a\0\0".to_vec(), zeros(70_000_000)].concat()),
        (b"iCCP", [b"a\0\0".to_vec(), zeros(1000)].concat()),
    ] {
        let bytes = png([1, 1], [8, 2], &[chunk], &[0, 255, 255, 255]);
        assert!(bytes.len() < 1 << 20);
        assert_eq!(read(&folder.file("a.png", &bytes)).unwrap().pixel(0, 0), [1.0; 4]);
    }
    // A text that is as long as it says; the decoder has 32 KiB besides.
    let mut bytes = png([1, 1], [8, 2], &[], &[0, 255, 255, 255])[..33].to_vec();
    let length = DECODER_BYTES_LIMIT + (1 << 16);
    bytes.extend((length as u32).to_be_bytes());
    bytes.extend(b"tEXt");
    let path = folder.file("a.png", &bytes);
    File::options().append(true).open(&path).unwrap().set_len(length + 100).unwrap();
    let said = read(&path).unwrap_err().to_string();
    assert!(said.contains("color profiles and texts"), "{said}");
}

#[test]
fn headers_without_end_are_refused() {
    let segment = [&[0xff, 0xe2, 0xff, 0xff][..], &[0; 0xfffd]].concat();
    let count = HEADER_BYTES_LIMIT as usize / segment.len() + 1;
    let said = refused_by_header("a.jpg", &jpeg(1, 1, &segment.repeat(count)));
    assert!(said.contains("header does not end"), "{said}");
    let said = refused_by_header("a.jpg", &[&[0xff, 0xd8][..], &vec![7; 17 << 20]].concat());
    assert!(said.contains("header does not end"), "{said}");
    let said = refused_by_header("a.hdr", &[&b"#?RGBE\n"[..], &vec![b'x'; 1 << 20]].concat());
    assert!(said.contains("does not end"), "{said}");
    let said = refused_by_header("a.hdr", &[&b"#?RGBE\n"[..], &b"a\n".repeat(9 << 20)].concat());
    assert!(said.contains("header does not end"), "{said}");
    let mut bytes = [20_000_630_u32.to_le_bytes(), 2_u32.to_le_bytes()].concat();
    attribute(&mut bytes, "comments", "string", &vec![b'x'; 17 << 20]);
    let said = refused_by_header("a.exr", &bytes);
    assert!(said.contains("header does not end"), "{said}");
    // Attributes that promise more than there is, or less than nothing.
    for size in [i32::MAX, 1_000_000, -1, i32::MIN] {
        let mut bytes = [20_000_630_u32.to_le_bytes(), 2_u32.to_le_bytes()].concat();
        bytes.extend(b"comments\0string\0");
        bytes.extend(size.to_le_bytes());
        let said = refused_by_header("a.exr", &bytes);
        assert!(said.contains("too early") || said.contains("negative"), "{said}");
    }
}

#[test]
fn endings_and_kinds_that_mislead_are_named() {
    let png = png([1, 1], [8, 2], &[], &[0, 1, 2, 3]);
    for name in ["a.jpg", "a.exr", "a.hdr"] {
        let said = refused_by_header(name, &png);
        assert!(said.contains("format PNG") && said.contains("rename"), "{said}");
        assert!(refused_by_header(name, b"").contains("empty"));
        assert!(refused_by_header(name, b"GIF89a").contains("does not begin"));
    }
    let mut deep = open_exr(&[Part::new(&COLOR, [0, 0, 3, 2])]);
    deep[5] |= 0x08;
    assert!(refused_by_header("a.exr", &deep).contains("deep data"));
    let (bytes, tables) = open_exr_with_tables(&[Part::new(&COLOR, [0, 0, 3, 2])]);
    let mut deep = bytes[..tables - 1].to_vec();
    attribute(&mut deep, "type", "string", b"deepscanline");
    deep.push(0);
    assert!(refused_by_header("a.exr", &deep).contains("deep data"));
    let precise = {
        let mut bytes = jpeg(4, 4, &[]);
        bytes[6] = 12;
        bytes
    };
    assert!(refused_by_header("a.jpg", &precise).contains("12 bits"));
}

#[test]
fn chunks_that_are_not_where_they_should_be_are_refused() {
    let (whole, tables) = open_exr_with_tables(&[Part::new(&COLOR, [0, 0, 3, 2])]);
    let entry = |at: usize| tables + 8 * at..tables + 8 * at + 8;
    // Twice the first, so that the second is missing.
    let mut bytes = whole.clone();
    bytes.copy_within(entry(0), entry(1).start);
    assert!(refused("a.exr", &bytes).contains("twice"));
    for offset in [0, 7, u64::MAX, 1 << 40, whole.len() as u64] {
        let mut bytes = whole.clone();
        bytes[entry(2)].copy_from_slice(&offset.to_le_bytes());
        refused("a.exr", &bytes);
    }
}

/// One small file of each format, of several kinds.
fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let mut film = Film::new(9, 5).unwrap();
    for row in 0..5 {
        for column in 0..9 {
            film.set(column, row, [column as f32 / 9.0, row as f32, 0.5, 0.75]);
        }
    }
    let mut samples: Vec<(&str, Vec<u8>)> = ["a.png", "a.exr", "a.hdr"]
        .map(|name| (name, encode(&film, Path::new(name), 1.0).unwrap()))
        .to_vec();
    let mut jpeg = Vec::new();
    image::codecs::jpeg::JpegEncoder::new(&mut jpeg)
        .encode(&[90; 9 * 5 * 3], 9, 5, image::ExtendedColorType::Rgb8)
        .unwrap();
    samples.push(("a.jpg", jpeg));
    let mut tiled = Part::new(&[("A", 1), ("Y", 0)], [-2, -1, 6, 4]);
    tiled.tile = Some(4);
    samples.push(("a.exr", open_exr(&[tiled.clone()])));
    let mut named = Part::new(&COLOR, [0, 0, 3, 2]);
    (named.name, tiled.name) = ("one", "two");
    samples.push(("a.exr", open_exr(&[named, tiled])));
    samples
}

#[test]
fn a_file_that_is_cut_is_an_error_or_the_whole_picture() {
    let folder = Folder::new();
    for (name, bytes) in samples() {
        let whole = read(&folder.file(name, &bytes)).unwrap();
        for length in 0..bytes.len() {
            let path = folder.file(name, &bytes[..length]);
            match read(&path) {
                // Only what follows the pixels of a PNG can be missing, or a part that is not read.
                Ok(film) => {
                    assert!(matches!(name, "a.png" | "a.exr"), "{name} {length}");
                    assert!(compare(&film, &whole).unwrap().identical);
                }
                Err(error) => assert!(error.to_string().contains(name), "{error}"),
            }
            if length < bytes.len() / 4 {
                assert!(read(&path).is_err(), "{name} {length}");
            }
        }
    }
}

#[test]
fn damage_is_an_error_or_another_picture() {
    let folder = Folder::new();
    let mut state = 1_u64;
    let mut number = |below: usize| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    const BYTES: [u8; 8] = [0, 1, 2, 0x7f, 0x80, 0xfe, 0xff, 0x55];
    for (name, whole) in samples() {
        for _ in 0..1500 {
            let mut bytes = whole.clone();
            for _ in 0..1 + number(3) {
                let at = number(bytes.len());
                bytes[at] = match number(3) {
                    0 => BYTES[number(BYTES.len())],
                    1 => bytes[at] ^ (1 << number(8)),
                    _ => number(256) as u8,
                };
            }
            let path = folder.file(name, &bytes);
            // Neither panics; a header is never refused where the picture is read.
            let (header, film) = (read_header(&path), read(&path));
            if let Ok(film) = &film {
                let header = header.unwrap();
                assert_eq!((header.width, header.height), (film.width(), film.height()));
            }
            if let Err(FilmError::Unreadable { source, .. }) = &film {
                panic!("{name}: {source}");
            }
        }
    }
}
