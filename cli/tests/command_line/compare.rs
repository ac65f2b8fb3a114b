//! `phenomenon compare`.

use phenomenon_runtime::film::{Film, read, write};

use crate::program::{Folder, printed, refused, run};

fn picture(folder: &Folder, name: &str, width: u32, pixel: [f32; 4]) -> String {
    let mut film = Film::new(width, 2).unwrap();
    film.set(0, 1, pixel);
    let path = folder.path(name);
    write(&film, path.as_ref(), 1.0).unwrap();
    path
}

#[test]
fn the_tolerance_decides() {
    let folder = Folder::new();
    let a = picture(&folder, "a.exr", 3, [0.5, 0.5, 0.5, 1.0]);
    let b = picture(&folder, "b.exr", 3, [0.5, 0.5, 0.75, 1.0]);
    let same = printed(&["compare", &a, &a, "--tolerance", "0"]);
    assert!(same.contains("all bits agree") && same.contains("rms 0e0"), "{same}");
    let differing = printed(&["compare", &a, &b]);
    assert!(differing.contains("not all bits agree"), "{differing}");
    // Raw: 0.25 in one of 18 values.
    assert!(differing.contains("maximum 2.5e-1"), "{differing}");
    assert_eq!(run(&["compare", &a, &b, "--tolerance", "0"]).code, Some(1));
    assert_eq!(run(&["compare", &a, &b, "--tolerance", "1e-3"]).code, Some(1));
    assert_eq!(run(&["compare", &a, &b, "--tolerance", "0.1"]).code, Some(0));
}

#[test]
fn a_tolerance_of_zero_asks_for_bits() {
    let folder = Folder::new();
    let opaque = picture(&folder, "a.exr", 1, [0.0, 0.0, 0.0, 1.0]);
    let clear = picture(&folder, "b.exr", 1, [0.0, 0.0, 0.0, 0.5]);
    let minus = picture(&folder, "c.exr", 1, [-0.0, 0.0, 0.0, 1.0]);
    let nan = picture(&folder, "d.exr", 1, [f32::NAN, 0.0, 0.0, 1.0]);
    for other in [&clear, &minus, &nan] {
        assert_eq!(run(&["compare", &opaque, other, "--tolerance", "0"]).code, Some(1), "{other}");
    }
    assert_eq!(run(&["compare", &nan, &nan, "--tolerance", "0"]).code, Some(0));
}

#[test]
fn the_difference_is_a_picture() {
    let folder = Folder::new();
    let a = picture(&folder, "a.exr", 3, [1.0, 0.0, 0.0, 1.0]);
    let b = picture(&folder, "b.png", 3, [0.0, 0.0, 0.0, 1.0]);
    let difference = folder.path("difference.exr");
    printed(&["compare", &a, &b, "-o", &difference]);
    let film = read(difference.as_ref()).unwrap();
    assert_eq!(film.pixel(0, 1), [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(film.pixel(2, 0), [0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = Folder::new();
    let a = picture(&folder, "a.exr", 3, [1.0; 4]);
    let wide = picture(&folder, "wide.exr", 4, [1.0; 4]);
    let broken = folder.file("broken.exr", b"no picture");
    refused(&["compare", &a, &wide], &["3 x 2", "4 x 2"]);
    refused(&["compare", &a, &broken], &["broken.exr"]);
    refused(&["compare", &a, "/nowhere/b.exr"], &["/nowhere/b.exr"]);
    refused(&["compare", &a, &a, "-o", "/nowhere/d.png"], &["-o /nowhere/d.png", "no folder"]);
    let folder_path = folder.path("taken.png");
    std::fs::create_dir(&folder_path).unwrap();
    refused(&["compare", &a, &a, "-o", &folder_path], &["this is a folder"]);
}
