//! OpenEXR: channels, layers, parts, windows.

use crate::files::{Part, open_exr, picture, refused, refused_by_header};

const WINDOW: [i32; 4] = [0, 0, 3, 2];
const COLOR: [(&str, i32); 3] = [("B", 2), ("G", 2), ("R", 2)];

/// What [`Part::new`] puts into a channel.
fn value(channel: i32, x: i32, y: i32) -> f32 {
    x as f32 + 0.25 * y as f32 + 8.0 * channel as f32
}

#[test]
fn every_type_of_channel_is_read() {
    for kind in [1, 2] {
        let channels = [("A", kind), ("B", kind), ("G", 2), ("R", kind)];
        let film = picture("a.exr", &open_exr(&[Part::new(&channels, WINDOW)]));
        assert_eq!(film.pixel(3, 2), [value(3, 3, 2), value(2, 3, 2), value(1, 3, 2), 3.5]);
        assert_eq!(film.pixel(0, 0), [24.0, 16.0, 8.0, 0.0]);
    }
    let mut whole = Part::new(&[("Y", 0)], WINDOW);
    whole.value = |_, x, _| if x == 3 { f64::from(u32::MAX) } else { f64::from(x) };
    let film = picture("a.exr", &open_exr(&[whole]));
    assert_eq!(film.pixel(2, 1), [2.0, 2.0, 2.0, 1.0]);
    assert_eq!(film.pixel(3, 0)[0], 4_294_967_296.0);
}

#[test]
fn grey_is_read_with_and_without_alpha() {
    for (channels, alpha) in [
        (vec![("Y", 1)], None),
        (vec![("A", 2), ("Y", 2)], Some(0)),
        // One channel is grey, whatever it is called.
        (vec![("density", 2)], None),
        (vec![("noise.value", 1)], None),
        (vec![("Z", 2)], None),
    ] {
        let film = picture("grey.exr", &open_exr(&[Part::new(&channels, WINDOW)]));
        let grey = value(channels.len() as i32 - 1, 1, 2);
        let alpha = alpha.map_or(1.0, |channel| value(channel, 1, 2));
        assert_eq!(film.pixel(1, 2), [grey, grey, grey, alpha], "{channels:?}");
    }
}

#[test]
fn what_is_not_finite_is_kept_for_who_reads() {
    let mut part = Part::new(&[("Y", 2)], WINDOW);
    part.value = |_, x, y| if (x, y) == (1, 1) { f64::NAN } else { f64::NEG_INFINITY };
    let film = picture("a.exr", &open_exr(&[part]));
    assert!(film.pixel(1, 1)[0].is_nan());
    assert_eq!(film.pixel(2, 2), [f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY, 1.0]);
}

#[test]
fn the_colors_without_a_layer_or_the_only_layer_are_read() {
    let several = [("B", 2), ("G", 2), ("R", 2), ("a.B", 2), ("a.G", 2), ("a.R", 2)];
    let film = picture("a.exr", &open_exr(&[Part::new(&several, WINDOW)]));
    assert_eq!(film.pixel(0, 0), [16.0, 8.0, 0.0, 1.0]);
    let one = [
        ("depth.Z", 2),
        ("normal.X", 2),
        ("normal.Y", 2),
        ("normal.Z", 2),
        ("view.main.A", 2),
        ("view.main.B", 2),
        ("view.main.G", 2),
        ("view.main.R", 2),
    ];
    let film = picture("a.exr", &open_exr(&[Part::new(&one, WINDOW)]));
    assert_eq!(film.pixel(0, 0), [56.0, 48.0, 40.0, 32.0]);
}

#[test]
fn what_is_not_clear_is_refused_with_the_channels_there_are() {
    let layers = [
        ("left.B", 2),
        ("left.G", 2),
        ("left.R", 2),
        ("right.B", 2),
        ("right.G", 2),
        ("right.R", 2),
    ];
    let said = refused_by_header("a.exr", &open_exr(&[Part::new(&layers, WINDOW)]));
    assert!(said.contains("several layers"), "{said}");
    assert!(said.contains("left.B, left.G, left.R, right.B, right.G, right.R"), "{said}");
    for channels in [
        vec![("U", 2), ("V", 2)],
        vec![("G", 2), ("R", 2)],
        vec![("X", 2), ("Y", 2), ("Z", 2)],
        vec![("b", 2), ("g", 2), ("r", 2)],
    ] {
        let said = refused_by_header("a.exr", &open_exr(&[Part::new(&channels, WINDOW)]));
        let names: Vec<&str> = channels.iter().map(|(name, _)| *name).collect();
        assert!(said.contains(&format!("its channels are {}:", names.join(", "))), "{said}");
    }
    let said = refused_by_header("a.exr", &open_exr(&[Part::new(&[], WINDOW)]));
    assert!(said.contains("neither R, G and B nor Y"), "{said}");
}

#[test]
fn luminance_with_chroma_is_refused_with_its_reason() {
    for channels in [vec![("BY", 1), ("RY", 1), ("Y", 1)], vec![("RY", 2), ("Y", 2)]] {
        let said = refused_by_header("a.exr", &open_exr(&[Part::new(&channels, WINDOW)]));
        assert!(said.contains("luminance and chroma"), "{said}");
    }
    let mut part = Part::new(&COLOR, [0, 0, 3, 3]);
    part.sampling = 2;
    let said = refused_by_header("a.exr", &open_exr(&[part]));
    assert!(said.contains("fewer samples than pixels"), "{said}");
}

#[test]
fn the_display_window_is_the_picture() {
    // The data begin at negative coordinates, reach past it at the left, and end before it.
    let mut part = Part::new(&[("A", 2), ("B", 2), ("G", 2), ("R", 2)], [-7, -5, -3, -2]);
    part.display = [-6, -5, 0, 0];
    for tile in [None, Some(1), Some(2), Some(64)] {
        part.tile = tile;
        let film = picture("a.exr", &open_exr(&[part.clone()]));
        assert_eq!((film.width(), film.height()), (7, 6));
        assert_eq!(film.pixel(0, 0), [3, 2, 1, 0].map(|channel| value(channel, -6, -5)));
        assert_eq!(film.pixel(3, 3), [3, 2, 1, 0].map(|channel| value(channel, -3, -2)));
        assert_eq!(film.pixel(4, 3), [0.0; 4]);
        assert_eq!(film.pixel(3, 4), [0.0; 4]);
    }
}

#[test]
fn tiles_are_put_together() {
    let mut part = Part::new(&COLOR, [0, 0, 12, 8]);
    part.tile = Some(5);
    let film = picture("a.exr", &open_exr(&[part]));
    for (x, y) in [(0, 0), (4, 4), (5, 5), (12, 8), (9, 1)] {
        let expected = [2, 1, 0].map(|channel| value(channel, x, y));
        assert_eq!(film.pixel(x as u32, y as u32)[..3], expected);
    }
}

#[test]
fn of_several_parts_the_one_with_colors_is_read() {
    let mut depth = Part::new(&[("Z", 2)], WINDOW);
    depth.name = "depth";
    let mut color = Part::new(&COLOR, [0, 0, 1, 4]);
    color.name = "beauty";
    for tile in [None, Some(2)] {
        color.tile = tile;
        let film = picture("a.exr", &open_exr(&[depth.clone(), color.clone()]));
        assert_eq!((film.width(), film.height()), (2, 5));
        assert_eq!(film.pixel(1, 4), [18.0, 10.0, 2.0, 1.0]);
    }
    let said = refused("a.exr", &open_exr(&[depth.clone(), depth.clone()]));
    assert!(said.contains("Z (depth)"), "{said}");
}
