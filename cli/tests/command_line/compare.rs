//! `phenomenon compare`.

use phenomenon_runtime::film::{Film, read, write};

use crate::program::{Folder, limited, printed, refused, run, was_refused};

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
    refused(&["compare", &a, "/nowhere/b.exr"], &["/nowhere/b.exr", "check its name"]);
    refused(&["compare", &a, "b.bmp"], &["b.bmp", "give a .png, .jpg, .exr or .hdr picture"]);
    refused(&["compare", &a, &a, "-o", "/nowhere/d.png"], &["-o /nowhere/d.png", "no folder"]);
    let folder_path = folder.path("taken.png");
    std::fs::create_dir(&folder_path).unwrap();
    refused(&["compare", &a, &a, "-o", &folder_path], &["this is a folder"]);
}

#[test]
fn what_is_not_finite_in_one_picture_fails_whatever_the_tolerance() {
    let folder = Folder::new();
    let picture = |name: &str, value: f32| picture(&folder, name, 3, [0.5, value, 0.0, 1.0]);
    let (nan, more, less) = (
        picture("nan.exr", f32::NAN),
        picture("more.exr", f32::INFINITY),
        picture("less.exr", f32::NEG_INFINITY),
    );
    // As a screen shows them, infinity is 1, and what is below 0 or no number is 0.
    let (white, black) = (picture("white.exr", 1.0), picture("black.exr", 0.0));
    for (a, b) in [(&nan, &black), (&white, &more), (&less, &nan), (&more, &less)] {
        for tolerance in [&[][..], &["--tolerance", "1"], &["--tolerance", "0"]] {
            let run = run(&[&["compare", a, b], tolerance].concat());
            assert_eq!(run.code, Some(1), "{a} {b} {tolerance:?}");
            assert!(run.output.contains("1 pixel has NaN or infinity"), "{}", run.output);
            assert!(run.output.contains("column 0 and row 1"), "{}", run.output);
        }
    }
    for same in [&nan, &more, &less] {
        assert_eq!(run(&["compare", same, same, "--tolerance", "0"]).code, Some(0));
    }
    let run = run(&["compare", &more, &black]);
    assert!(run.output.contains("green is inf and 0"), "{}", run.output);
}

fn json(arguments: &[&str], code: i32) -> serde_json::Value {
    let run = run(&[&["compare", "--format", "json"], arguments].concat());
    assert_eq!(run.code, Some(code), "{run:?}");
    serde_json::from_str(&run.output).unwrap()
}

#[test]
fn programs_read_what_was_found() {
    let folder = Folder::new();
    let a = picture(&folder, "a.exr", 3, [4.0, 0.0, 0.0, 1.0]);
    let b = picture(&folder, "b.exr", 3, [1.0, 0.0, 0.0, 0.5]);
    let found = json(&[&a, &b], 0);
    let keys: Vec<&str> = found.as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(
        keys,
        [
            "version",
            "width",
            "height",
            "rms",
            "maximum",
            "raw",
            "alpha",
            "identical",
            "not_finite",
            "tolerance",
            "within"
        ]
    );
    assert_eq!(
        (&found["version"], &found["width"], &found["height"]),
        (&1.into(), &3.into(), &2.into())
    );
    // On a screen both are white; raw: 3 in one of 18 values, alpha 0.5 in one of 6.
    assert_eq!((&found["rms"], &found["maximum"]), (&0.0.into(), &0.0.into()));
    assert_eq!(found["raw"]["maximum"], 3.0);
    assert_eq!(found["raw"]["rms"], 0.5_f64.sqrt());
    assert_eq!(found["alpha"]["maximum"], 0.5);
    assert_eq!(found["identical"], false);
    assert_eq!(found["not_finite"], serde_json::json!({ "pixels": 0, "first": null }));
    assert_eq!((&found["tolerance"], &found["within"]), (&serde_json::Value::Null, &true.into()));

    let found = json(&[&a, &b, "--tolerance", "0"], 1);
    assert_eq!((&found["tolerance"], &found["within"]), (&0.0.into(), &false.into()));
    let found = json(&[&a, &a, "--tolerance", "0"], 0);
    assert_eq!((&found["identical"], &found["within"]), (&true.into(), &true.into()));

    let nan = picture(&folder, "nan.exr", 3, [4.0, 0.0, f32::NAN, f32::NEG_INFINITY]);
    let found = json(&[&nan, &a, "--tolerance", "1"], 1);
    let first = serde_json::json!(
        { "column": 0, "row": 1, "channel": "blue", "a": "NaN", "b": 0.0 }
    );
    assert_eq!(found["not_finite"], serde_json::json!({ "pixels": 1, "first": first }));
    assert_eq!(found["raw"], serde_json::json!({ "rms": "inf", "maximum": "inf" }));
    assert_eq!(found["alpha"]["maximum"], "inf");
    assert_eq!(found["rms"], 0.0);
}

#[test]
fn pictures_of_different_formats_are_compared() {
    let folder = Folder::new();
    // White and black are the same in all formats.
    let names = ["a.exr", "a.png", "a.hdr"];
    let paths = names.map(|name| picture(&folder, name, 9, [1.0, 0.0, 1.0, 1.0]));
    for a in &paths {
        for b in &paths {
            let found = json(&[a, b], 0);
            assert_eq!((&found["rms"], &found["raw"]["rms"]), (&0.0.into(), &0.0.into()));
        }
    }
}

/// What a bomb promises, and what memory can hold.
#[test]
fn large_pictures_and_little_memory_are_refused_with_a_message() {
    let folder = Folder::new();
    let bomb = folder.file("bomb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 65000 +X 65000\n");
    refused(&["compare", &bomb, &bomb], &["65000 x 65000", "bomb.hdr", "scale it down"]);
    let scene = r#"{"scene":"s","camera":{"position":[0,0,5],"look_at":[0,0,0]},"objects":[],
        "environment":{"image":"bomb.hdr"}}"#;
    let scene = folder.file("s.json", scene);
    let found = run(&["check", &scene]);
    assert_eq!(found.code, Some(1), "{found:?}");
    assert!(found.output.contains("65000 x 65000"), "{found:?}");
}

/// The limits are far from what decides: a film that no machine can fit, and threads of which some
/// fit, however much the program holds besides, and however many cores there are.
#[cfg(unix)]
#[test]
fn little_memory_ends_in_a_message() {
    let folder = Folder::new();
    let large = folder.path("large.png");
    write(&Film::new(3000, 3000).unwrap(), large.as_ref(), 1.0).unwrap();
    let out = folder.path("out.png");
    let render = ["render", "graphs/rainbow/rainbow.json", "--spp", "1", "-o", &out];
    let with = |more: &[&'static str]| [&render[..], more].concat();
    let cases = [
        // 144 MB for each picture, 1 GiB for the film, 64 MiB for each thread.
        (vec!["compare", &large, &large], 200_000, ["not enough memory", "3000 x 3000"]),
        (with(&["--size", "8192x8192"]), 800_000, ["not enough memory", "8192 x 8192"]),
        (
            with(&["--threads", "200"]),
            2_000_000,
            ["cannot start 200 rendering threads", "--threads"],
        ),
    ];
    for (arguments, kibibytes, parts) in cases {
        was_refused(&limited(&arguments, &format!("ulimit -v {kibibytes}")), &arguments, &parts);
        assert!(!std::path::Path::new(&out).exists(), "{arguments:?}");
    }
}
