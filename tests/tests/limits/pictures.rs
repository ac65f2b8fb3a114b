//! Limits of pictures that are read: most are met by headers alone.

use std::fs::File;
use std::path::Path;

use phenomenon_compiler::check::OnDisk;
use phenomenon_compiler::diagnostics::Finding;
use phenomenon_compiler::document;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::film::{
    CHANNEL_LIMIT, CHUNK_BYTES_LIMIT, CHUNK_LIMIT, DECODER_BYTES_LIMIT, FILE_BYTES_LIMIT, Film,
    HEADER_BYTES_LIMIT, PART_LIMIT, PIXEL_LIMIT, SIDE_LIMIT, read, read_header, write,
};
use phenomenon_runtime::link::check_with_graphs;
use phenomenon_runtime::scene_file::{Assets, read_scene};
use phenomenon_runtime::texture::TEXTURE_PIXEL_LIMIT;

use super::{CAMERA, Limit, limit, sparse};

pub const LIMITS: [Limit; 10] = [
    limit("bytes of a file", FILE_BYTES_LIMIT, "`file-too-large`", huge_picture),
    limit("bytes before the pixels", HEADER_BYTES_LIMIT, "`unusable-file`", long_header),
    limit("pixels on a side", SIDE_LIMIT as u64, "`unusable-file`", wide_file),
    limit("pixels", PIXEL_LIMIT, "`unusable-file`", large_file),
    limit(
        "bytes of a text or color profile in a PNG",
        DECODER_BYTES_LIMIT,
        "`unusable-file`",
        long_text,
    ),
    limit("parts of an OpenEXR", PART_LIMIT as u64, "`unusable-file`", many_picture_parts),
    limit(
        "channels of a part of an OpenEXR",
        CHANNEL_LIMIT as u64,
        "`unusable-file`",
        many_channels,
    ),
    limit("chunks of pixels in an OpenEXR", CHUNK_LIMIT, "`unusable-file`", many_chunks),
    limit("bytes of pixels in a chunk", CHUNK_BYTES_LIMIT, "`unusable-file`", large_chunk),
    limit(
        "pixels of all textures of a scene together, coarser versions for footprints included",
        TEXTURE_PIXEL_LIMIT,
        "`unusable-file`",
        many_texture_pixels,
    ),
];

/// The code of the one finding in a scene whose environment is this file.
fn environment(folder: &Path, name: &str) -> Option<String> {
    let text =
        format!(r#"{{"scene":"s",{CAMERA},"objects":[],"environment":{{"image":"{name}"}}}}"#);
    let file = read_scene("scene.json", text.as_bytes(), folder);
    match file.findings.as_slice() {
        [] => None,
        [finding] => Some(format!("`{}`", finding.code)),
        findings => panic!("{findings:?}"),
    }
}

/// What is said of an environment of these bytes, where the header of one of those is fine.
fn picture(folder: &Path, name: &str, at: &[u8], past: &[u8]) -> String {
    std::fs::write(folder.join(name), at).unwrap();
    read_header(&folder.join(name)).unwrap();
    std::fs::write(folder.join(name), past).unwrap();
    environment(folder, name).unwrap()
}

fn huge_picture(folder: &Path) -> String {
    sparse(&folder.join("huge.png"), FILE_BYTES_LIMIT + 1);
    environment(folder, "huge.png").unwrap()
}

fn long_header(folder: &Path) -> String {
    let with = |bytes: u64| {
        let start = "#?RGBE\n";
        let end = "\n-Y 1 +X 1\n";
        let comment = bytes as usize - start.len() - end.len();
        let line = format!("{}\n", "#".repeat(255));
        let last = format!("{}\n", "#".repeat(comment % 256));
        let last = if comment.is_multiple_of(256) { "" } else { &last[1..] };
        format!("{start}{}{last}{end}", line.repeat(comment / 256)).into_bytes()
    };
    picture(folder, "a.hdr", &with(HEADER_BYTES_LIMIT), &with(HEADER_BYTES_LIMIT + 1))
}

fn hdr(width: u64, height: u64) -> Vec<u8> {
    format!("#?RGBE\n\n-Y {height} +X {width}\n").into_bytes()
}

fn wide_file(folder: &Path) -> String {
    let side = u64::from(SIDE_LIMIT);
    picture(folder, "a.hdr", &hdr(side, 1), &hdr(side + 1, 1))
}

fn large_file(folder: &Path) -> String {
    let side = PIXEL_LIMIT.isqrt();
    picture(folder, "a.hdr", &hdr(side, side), &hdr(side, side + 1))
}

fn long_text(folder: &Path) -> String {
    let path = folder.join("a.png");
    write(&Film::new(1, 1).unwrap(), &path, 1.0).unwrap();
    assert_eq!(environment(folder, "a.png"), None);
    let whole = std::fs::read(&path).unwrap();
    // After the signature and the header, a text of zeros: most of it is a hole in the file.
    let mut bytes = whole[..33].to_vec();
    // The decoder has 32 KiB besides.
    let length = DECODER_BYTES_LIMIT + (1 << 16);
    bytes.extend((length as u32).to_be_bytes());
    bytes.extend(b"tEXt");
    std::fs::write(&path, bytes).unwrap();
    let file = File::options().append(true).open(&path).unwrap();
    file.set_len(length + 100).unwrap();
    let error = read(&path).unwrap_err().to_string();
    assert!(error.contains(&DECODER_BYTES_LIMIT.to_string()), "{error}");
    environment(folder, "a.png").unwrap()
}

/// The header of an OpenEXR file of several parts with tiles.
fn exr(parts: usize, channels: usize, side: i32, tile: u32) -> Vec<u8> {
    let mut part = Vec::new();
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        part.extend(format!("{name}\0{kind}\0").bytes());
        part.extend((value.len() as i32).to_le_bytes());
        part.extend(value);
    };
    let channel = [b"Y\0\x02\0\0\0\0\0\0\0".to_vec(), [1, 0, 0, 0].repeat(2)].concat();
    attribute("channels", "chlist", &[channel.repeat(channels), vec![0]].concat());
    let window = [0, 0, side - 1, side - 1].map(i32::to_le_bytes).concat();
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("compression", "compression", &[0]);
    attribute("tiles", "tiledesc", &[&tile.to_le_bytes()[..], &tile.to_le_bytes(), &[0]].concat());
    attribute("type", "string", b"tiledimage");
    part.push(0);
    let magic = [20_000_630_u32.to_le_bytes(), 0x1002_u32.to_le_bytes()].concat();
    [magic, part.repeat(parts), vec![0]].concat()
}

fn many_picture_parts(folder: &Path) -> String {
    picture(folder, "a.exr", &exr(PART_LIMIT, 1, 1, 1), &exr(PART_LIMIT + 1, 1, 1, 1))
}

fn many_channels(folder: &Path) -> String {
    picture(folder, "a.exr", &exr(1, CHANNEL_LIMIT, 1, 1), &exr(1, CHANNEL_LIMIT + 1, 1, 1))
}

fn many_chunks(folder: &Path) -> String {
    let side = CHUNK_LIMIT.isqrt() as i32;
    picture(folder, "a.exr", &exr(1, 1, side, 1), &exr(1, 1, side + 1, 1))
}

fn large_chunk(folder: &Path) -> String {
    // Of 4 bytes a channel.
    let tile = (CHUNK_BYTES_LIMIT / 4 / CHANNEL_LIMIT as u64).isqrt() as u32;
    let with = |tile: u32| exr(1, CHANNEL_LIMIT, 1, tile);
    picture(folder, "a.exr", &with(tile), &with(tile + 1))
}

/// What is said of a scene whose environment reads that many pictures of the largest size there is; of each there is no
/// more than its header.
fn textures(folder: &Path, count: u64) -> Vec<Finding> {
    let side = PIXEL_LIMIT.isqrt();
    let (mut nodes, mut sum) = (Vec::new(), Vec::new());
    for at in 0..count {
        let header = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {side} +X {side}\n");
        std::fs::write(folder.join(format!("{at}.hdr")), header).unwrap();
        let texture = format!(r#"{{"texture":"{at}.hdr"}}"#);
        nodes.push(format!(
            r#""t{at}":{{"type":"texture_lookup","inputs":{{"texture":{texture}}}}}"#
        ));
        sum.push(format!(r#"{{"node":"t{at}"}}"#));
    }
    let nodes = format!(
        r#"{},"s":{{"type":"sum","inputs":{{"values":[{}]}}}}"#,
        nodes.join(","),
        sum.join(",")
    );
    let graph = format!(
        r#"{{"phenomenon":"p","nodes":{{{nodes}}},"roots":{{"environment":{{"node":"s"}}}}}}"#
    );
    std::fs::write(folder.join("graph.json"), graph).unwrap();
    let text =
        format!(r#"{{"scene":"s",{CAMERA},"objects":[],"environment":{{"file":"graph.json"}}}}"#);
    let document = document::read("scene.json", text.as_bytes()).unwrap();
    let library = NodeLibrary::standard();
    check_with_graphs(&document, folder, &library, &OnDisk, &Assets::default()).findings
}

fn many_texture_pixels(folder: &Path) -> String {
    let most = TEXTURE_PIXEL_LIMIT / PIXEL_LIMIT;
    assert!(textures(folder, most).is_empty());
    let [finding] = &*textures(folder, most + 1) else { panic!("one finding") };
    let said = format!("with it all textures have {} pixels", TEXTURE_PIXEL_LIMIT + PIXEL_LIMIT);
    assert!(finding.message.contains(&said), "{finding}");
    assert_eq!(finding.place.text(), "\"graph.json\"");
    format!("`{}`", finding.code)
}
