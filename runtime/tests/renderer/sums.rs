//! Sums over samples lose no digits, and regions are parts of the whole.

use phenomenon_runtime::film::Film;
use phenomenon_runtime::render::{
    Region, RenderError, SAMPLE_LIMIT, Settings, render, render_region,
};
use phenomenon_runtime::scene::Scene;
use phenomenon_runtime::scene_file::read_scene;
use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::engine::Shade;

fn scene(environment: &str) -> Scene {
    let text = format!(
        r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }}, "objects": [],
             "environment": {environment} }}"#
    );
    let file = read_scene("s.json", text.as_bytes(), Path::new("."));
    let none = |_: &_| -> Result<Arc<dyn Shade>, String> { Err("no graphs here".into()) };
    file.scene.unwrap_or_else(|| panic!("{:?}", file.findings)).build(none).unwrap()
}

fn picture(environment: &str, settings: &Settings) -> Film {
    render(&scene(environment), settings, &|_, _| ()).unwrap().film
}

#[test]
fn a_million_equal_samples_have_their_value_for_mean() {
    let settings =
        Settings { width: 1, height: 1, samples: SAMPLE_LIMIT, threads: 1, ..Settings::default() };
    // In sums of 32 bits these come out wrong in the third digit.
    for numbers in ["0.1, 0.7, 1e-30", "16777217, 3.3333333, 1e12"] {
        let film = picture(&format!(r#"{{ "color": [{numbers}] }}"#), &settings);
        let wanted: Vec<f32> = numbers.split(", ").map(|text| text.parse().unwrap()).collect();
        assert_eq!(film.pixel(0, 0)[..3], wanted, "{numbers}");
    }
}

#[test]
fn the_mean_is_rounded_once() {
    for samples in [1, 3, 5, 7, 1000] {
        let settings = Settings { width: 2, height: 2, samples, ..Settings::default() };
        let film = picture(r#"{ "color": [0.1, 0.3, 16777215] }"#, &settings);
        for at in [(0, 0), (1, 1)] {
            assert_eq!(film.pixel(at.0, at.1)[..3], [0.1, 0.3, 16_777_215.0], "{samples}");
        }
    }
}

#[test]
fn a_region_lies_in_the_picture() {
    let sky =
        r#"{ "gradient": { "zenith": [0, 0, 1], "horizon": [1, 0, 0], "ground": [0, 1, 0] } }"#;
    let whole = Settings { width: 40, height: 24, samples: 2, tile: 7, ..Settings::default() };
    let film = picture(sky, &whole);
    let region = |x, y, width, height| Region { x, y, width, height };
    let rendered = render_region(&scene(sky), &whole, region(13, 5, 20, 18), &|_, _| ());
    let part = rendered.unwrap().film;
    for row in 0..18 {
        for column in 0..20 {
            assert_eq!(part.pixel(column, row), film.pixel(13 + column, 5 + row));
        }
    }
    for wrong in [
        region(0, 0, 41, 1),
        region(40, 0, 1, 1),
        region(0, 23, 1, 2),
        region(u32::MAX, 0, 2, 1),
        region(0, 0, 0, 1),
    ] {
        let refused = render_region(&scene(sky), &whole, wrong, &|_, _| ());
        assert!(matches!(refused, Err(RenderError::Region { .. })), "{wrong:?}");
    }
}
