//! What is written can be read, as exactly as its format permits.

use phenomenon_runtime::film::{Film, encode, read};

use crate::files::Folder;

/// Numbers below 2^64 from a seed.
fn numbers(mut state: u64) -> impl FnMut() -> u64 {
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 16
    }
}

fn back(film: &Film, name: &str) -> Film {
    let folder = Folder::new();
    read(&folder.file(name, &encode(film, name.as_ref(), 1.0).unwrap())).unwrap()
}

/// The error of a value is at most half a step of the pixel's largest, or all of it where the pixel is
/// too dark for the format.
fn require_near(written: [f32; 4], found: [f32; 4]) {
    let value = |k: usize| if written[k] > 0.0 { written[k].min(1.694_765_7e38) } else { 0.0 };
    let largest = value(0).max(value(1)).max(value(2));
    // Rounded up to a power of two, the steps are twice as wide.
    let step = f64::from(largest.max(found[0]).max(found[1]).max(found[2])) / 128.0;
    for k in 0..3 {
        let error = (f64::from(value(k)) - f64::from(found[k])).abs();
        let dark = largest < 2.0_f32.powi(-128) && found[k] == 0.0;
        assert!(dark || error <= step / 2.0, "{written:?} became {found:?}");
    }
    assert_eq!(found[3], 1.0);
}

#[test]
fn hdr_has_its_widths_and_values() {
    const HARD: [f32; 14] = [
        0.0,
        -0.0,
        1e-45,
        1e-39,
        3e-39,
        1e-20,
        0.999,
        1.0,
        255.5,
        3e38,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
        -1.0,
    ];
    let mut number = numbers(7);
    for width in [1, 2, 7, 8, 9, 127, 128, 129, 255, 257, 1000] {
        let mut film = Film::new(width, 3).unwrap();
        for row in 0..3 {
            for column in 0..width {
                // Long runs in the first row, hard numbers in the second, anything in the last.
                let pixel = match row {
                    0 => [(column / 150) as f32, 0.5, 0.25, 1.0],
                    1 => std::array::from_fn(|_| HARD[number() as usize % HARD.len()]),
                    _ => std::array::from_fn(|_| f32::from_bits(number() as u32)),
                };
                film.set(column, row, pixel);
            }
        }
        let found = back(&film, "a.hdr");
        assert_eq!((found.width(), found.height()), (width, 3));
        for (written, found) in film.pixels().iter().zip(found.pixels()) {
            require_near(*written, *found);
        }
        // What was read once is written as it was.
        assert_eq!(back(&found, "a.hdr"), found);
    }
}

#[test]
fn hdr_goes_up_to_the_widest_picture() {
    for width in [32_767, 32_768, 65_536] {
        let mut film = Film::new(width, 2).unwrap();
        for column in 0..width {
            film.set(column, 1, [(column % 251) as f32, (column / 251) as f32, 1.0, 1.0]);
        }
        let bytes = encode(&film, "a.hdr".as_ref(), 1.0).unwrap();
        let flat = u64::from(width) * 8;
        assert_eq!(bytes.len() as u64 > flat, width > 32_767, "{width}: {}", bytes.len());
        let found = back(&film, "a.hdr");
        for (written, found) in film.pixels().iter().zip(found.pixels()) {
            require_near(*written, *found);
        }
    }
}

#[test]
fn exr_keeps_bits_alpha_and_order() {
    let mut number = numbers(11);
    let mut film = Film::new(33, 17).unwrap();
    for row in 0..17 {
        for column in 0..33 {
            film.set(column, row, std::array::from_fn(|_| f32::from_bits(number() as u32)));
        }
    }
    film.set(0, 0, [1e-45, -0.0, f32::INFINITY, 0.5]);
    let found = back(&film, "a.exr");
    let bits =
        |film: &Film| -> Vec<u32> { film.pixels().iter().flatten().map(|x| x.to_bits()).collect() };
    assert_eq!(bits(&found), bits(&film));
}
