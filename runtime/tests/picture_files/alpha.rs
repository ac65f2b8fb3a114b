//! Straight and associated alpha.

use phenomenon_compiler::effects::{Lookup, Sampling};
use phenomenon_compiler::values::{Space, Texture};
use phenomenon_runtime::film::{Film, encode, read, read_as, srgb_decoded, write};
use phenomenon_runtime::texture::Textures;

use crate::files::{Folder, Part, open_exr, png};

fn color(path: &std::path::Path, space: Space, at: [f32; 2]) -> [f32; 4] {
    let texture = Texture { file: path.display().to_string(), space };
    let mut textures = Textures::default();
    textures.open(&texture).unwrap();
    let lookup = Lookup { uv: at, ..Lookup::default() };
    textures
        .picture(textures.number(&texture))
        .unwrap()
        .color(Sampling::default(), &lookup)
        .unwrap()
}

#[test]
fn what_is_not_there_has_no_color_between_pixels() {
    let folder = Folder::new();
    // Opaque white beside clear pixels of colours nobody sees.
    for hidden in [[0, 0, 0], [255, 0, 0], [0, 255, 255]] {
        let rows = [&[0, 255, 255, 255, 255][..], &hidden, &[0]].concat();
        let path = folder.file("edge.png", &png([2, 1], [8, 6], &[], &rows));
        for space in [Space::Srgb, Space::Linear] {
            for (u, alpha) in [(0.25, 1.0), (0.375, 0.75), (0.5, 0.5), (0.625, 0.25)] {
                let found = color(&path, space, [u, 0.5]);
                assert!(found.iter().all(|x| (x - alpha).abs() < 1e-6), "{space:?} {u}: {found:?}");
            }
        }
    }
}

#[test]
fn png_and_exr_of_one_picture_are_one_picture() {
    let folder = Folder::new();
    let rows = [0, 255, 128, 0, 51, 10, 20, 30, 255, 200, 100, 50, 0];
    let straight = folder.file("a.png", &png([3, 1], [8, 6], &[], &rows));
    let film = read(&straight).unwrap();
    let half = srgb_decoded(128.0 / 255.0);
    assert_eq!(film.pixel(0, 0), [0.2, half * 0.2, 0.0, 0.2]);
    let opaque = [10.0_f32, 20.0, 30.0].map(|x| srgb_decoded(x / 255.0));
    assert_eq!(film.pixel(1, 0), [opaque[0], opaque[1], opaque[2], 1.0]);
    assert_eq!(film.pixel(2, 0), [0.0; 4]);
    let associated = straight.with_extension("exr");
    write(&film, &associated, 1.0).unwrap();
    for u in [0.1, 0.3, 1.0 / 3.0, 0.5, 0.9] {
        assert_eq!(
            color(&straight, Space::Srgb, [u, 0.5]),
            color(&associated, Space::Linear, [u, 0.5])
        );
    }
}

#[test]
fn opaque_pictures_keep_their_bits() {
    let folder = Folder::new();
    for byte in 0..=255 {
        let film = [[0, byte, byte, byte, 255], [0, byte, byte, byte, 0]].map(|row| {
            let rows = &row[..if row[4] == 255 { 5 } else { 4 }];
            let kind = if rows.len() == 5 { 6 } else { 2 };
            read(&folder.file("a.png", &png([1, 1], [8, kind], &[], rows))).unwrap()
        });
        let expected = srgb_decoded(f32::from(byte) / 255.0);
        for film in film {
            assert_eq!(film.pixel(0, 0), [expected, expected, expected, 1.0]);
        }
    }
}

#[test]
fn encoded_colors_of_an_exr_are_decoded_in_their_straight_form() {
    let folder = Folder::new();
    let mut part = Part::new(&[("A", 2), ("B", 2), ("G", 2), ("R", 2)], [0, 0, 2, 0]);
    // Alpha of 0.5, 1 and 0; red of 0.25.
    part.value = |channel, x, _| match channel {
        0 => [0.5, 1.0, 0.0][x as usize],
        3 => 0.25,
        _ => 0.0,
    };
    let path = folder.file("a.exr", &open_exr(&[part]));
    let film = read_as(&path, Some(Space::Srgb)).unwrap();
    assert_eq!(film.pixel(0, 0), [srgb_decoded(0.5) * 0.5, 0.0, 0.0, 0.5]);
    assert_eq!(film.pixel(1, 0), [srgb_decoded(0.25), 0.0, 0.0, 1.0]);
    assert_eq!(film.pixel(2, 0), [srgb_decoded(0.25), 0.0, 0.0, 0.0]);
    assert_eq!(read(&path).unwrap().pixel(0, 0), [0.25, 0.0, 0.0, 0.5]);
}

#[test]
fn a_png_has_alpha_only_where_something_shows_through() {
    let folder = Folder::new();
    let mut film = Film::new(2, 1).unwrap();
    film.set(0, 0, [0.5, 0.25, 0.0, 1.0]);
    // A mean of ones may end just beside 1.
    film.set(1, 0, [0.5, 0.25, 0.0, 1.0 - f32::EPSILON]);
    let kind = |film: &Film| encode(film, "a.png".as_ref(), 1.0).unwrap()[25];
    assert_eq!(kind(&film), 2);
    film.set(1, 0, [0.25, 0.5, 0.0, 0.5]);
    assert_eq!(kind(&film), 6);
    let path = folder.file("a.png", &encode(&film, "a.png".as_ref(), 1.0).unwrap());
    let back = read(&path).unwrap();
    // Straight 0.5 and 1, in 8 bits, associated again.
    let [red, green, blue, alpha] = back.pixel(1, 0);
    assert!((red - 0.25).abs() < 3e-3 && (green - 0.5).abs() < 3e-3 && blue == 0.0);
    assert_eq!(alpha, 128.0 / 255.0);
    for alpha in [f32::NAN, -1.0, f32::NEG_INFINITY] {
        film.set(1, 0, [0.25, 0.5, 0.0, alpha]);
        assert_eq!(kind(&film), 6, "{alpha}");
    }
    film.set(1, 0, [0.25, 0.5, 0.0, f32::INFINITY]);
    assert_eq!(kind(&film), 2);
}
