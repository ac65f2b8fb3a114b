//! PNG: every kind of pixel, and JPEG.

use phenomenon_runtime::film::{Channels, Format, read, read_header, srgb_decoded};

use crate::files::{Folder, picture, png};

fn decoded(value: f64) -> f32 {
    srgb_decoded(value as f32)
}

#[test]
fn every_kind_of_pixel_is_read() {
    let grey = |value: f64, alpha: f32| {
        let value = decoded(value) * alpha;
        [value, value, value, alpha]
    };
    // Grey of 1, 2, 4, 8 and 16 bits: the largest value, and one more.
    for (depth, rows, second) in [
        (1, vec![0, 0b1000_0000], 0.0),
        (2, vec![0, 0b1101_0000], 1.0 / 3.0),
        (4, vec![0, 0xf7], 7.0 / 15.0),
        (8, vec![0, 255, 51], 0.2),
        (16, vec![0, 0xff, 0xff, 0x12, 0x34], f64::from(0x1234) / 65_535.0),
    ] {
        let film = picture("a.png", &png([2, 1], [depth, 0], &[], &rows));
        assert_eq!(film.pixel(0, 0), [1.0; 4], "{depth}");
        let (found, expected) = (film.pixel(1, 0), grey(second, 1.0));
        assert!((found[0] - expected[0]).abs() < 1e-7 && found[3] == 1.0, "{depth}: {found:?}");
    }
    let film = picture("a.png", &png([2, 1], [8, 4], &[], &[0, 255, 51, 102, 0]));
    assert_eq!(film.pixel(0, 0), grey(1.0, 0.2));
    assert_eq!(film.pixel(1, 0), [0.0; 4]);
    let film = picture("a.png", &png([1, 1], [16, 4], &[], &[0, 255, 255, 0x80, 0]));
    assert_eq!(film.pixel(0, 0), grey(1.0, 32_768.0 / 65_535.0));
    let film = picture("a.png", &png([1, 1], [16, 6], &[], &[0, 255, 255, 0, 0, 0, 0, 51, 51]));
    assert_eq!(film.pixel(0, 0), [0.2, 0.0, 0.0, 0.2]);
}

#[test]
fn palettes_and_transparent_colors_are_read() {
    let palette = (b"PLTE", vec![255, 0, 0, 0, 255, 0]);
    let film =
        picture("a.png", &png([2, 1], [1, 3], std::slice::from_ref(&palette), &[0, 0b0100_0000]));
    assert_eq!(film.pixel(0, 0), [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(film.pixel(1, 0), [0.0, 1.0, 0.0, 1.0]);
    let clear = (b"tRNS", vec![51]);
    let film = picture("a.png", &png([2, 1], [8, 3], &[palette, clear], &[0, 0, 1]));
    assert_eq!(film.pixel(0, 0), [0.2, 0.0, 0.0, 0.2]);
    assert_eq!(film.pixel(1, 0), [0.0, 1.0, 0.0, 1.0]);
    let clear = (b"tRNS", vec![0, 255, 0, 255, 0, 255]);
    let rows = [0, 255, 255, 255, 255, 255, 254];
    let film = picture("a.png", &png([2, 1], [8, 2], &[clear], &rows));
    assert_eq!(film.pixel(0, 0), [0.0; 4]);
    assert_eq!(film.pixel(1, 0)[3], 1.0);
}

#[test]
fn profiles_change_nothing() {
    let plain = picture("a.png", &png([1, 1], [8, 2], &[], &[0, 10, 128, 250]));
    for chunk in [
        (b"gAMA", 100_000_u32.to_be_bytes().to_vec()),
        (b"gAMA", 45_455_u32.to_be_bytes().to_vec()),
        (b"sRGB", vec![0]),
        (b"tEXt", b"Comment\0nothing".to_vec()),
    ] {
        let film = picture("a.png", &png([1, 1], [8, 2], &[chunk], &[0, 10, 128, 250]));
        assert_eq!(film, plain);
    }
}

#[test]
fn headers_say_what_there_is() {
    let folder = Folder::new();
    for (color, channels) in [
        (0, Channels::Grey),
        (2, Channels::Color),
        (4, Channels::GreyAlpha),
        (6, Channels::ColorAlpha),
    ] {
        let path = folder.file("a.png", &png([70, 30], [8, color], &[], &[]));
        let header = read_header(&path).unwrap();
        assert_eq!((header.format, header.width, header.height), (Format::Png, 70, 30));
        assert_eq!(header.channels, channels);
    }
    let path = folder.file("a.png", &png([70, 30], [8, 6], &[], &[]));
    assert_eq!(read_header(&path).unwrap().to_string(), "PNG, 70 x 30, color with alpha");
}

#[test]
fn jpeg_is_read_grey_and_colored() {
    use image::ExtendedColorType::{L8, Rgb8};
    let folder = Folder::new();
    for (color, samples, channels) in
        [(L8, vec![200; 40], Channels::Grey), (Rgb8, vec![200; 120], Channels::Color)]
    {
        let mut bytes = Vec::new();
        image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, 100)
            .encode(&samples, 8, 5, color)
            .unwrap();
        let path = folder.file("a.jpeg", &bytes);
        assert_eq!(read_header(&path).unwrap().channels, channels);
        let film = read(&path).unwrap();
        assert_eq!((film.width(), film.height()), (8, 5));
        let [red, .., alpha] = film.pixel(7, 4);
        assert!((red - decoded(200.0 / 255.0)).abs() < 0.02 && alpha == 1.0, "{red}");
    }
}
