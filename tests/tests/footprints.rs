//! What a pixel covers, from the camera to the texture: a chequered floor fades to its mean, of a picture or without one,
//! and every engine, batch and number of threads sees the same. And pictures in tiles, from their files to the image.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::check::read_graph_file;
use phenomenon_compiler::engine::{Engine, Options, Shader};
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_compiler::values::Literal;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::film::Film;
use phenomenon_runtime::geometry::{Mesh, Transform};
use phenomenon_runtime::render::{Settings, render};
use phenomenon_runtime::scene::{Scene, SceneBuilder, SceneError};

/// A picture of two by two squares, black and white, on a floor of 1000 units: placed by `place_2d`, or by the floor's
/// coordinates, which run from 0 to 1.
const FLOOR: &str = r#"{ "phenomenon": "floor",
    "nodes": {
        "place": { "type": "place_2d", "inputs": { "scale": [0.002, 0.002, 1] } },
        "read": { "type": "texture_lookup", "inputs": { "texture": { "texture": "checks.png" },
            "u": { "node": "place", "output": "u" }, "v": { "node": "place", "output": "v" }, "filter": FILTER } } },
    "roots": { "material": { "node": "read", "output": "color" } } }"#;

/// The same board without a picture.
const BOARD: &str = r#"{ "phenomenon": "board",
    "nodes": {
        "place": { "type": "place_2d", "inputs": { "scale": [0.002, 0.002, 1] } },
        "read": { "type": "checker", "inputs": { "tiling": [2, 2, 2], "filter": FILTER,
            "u": { "node": "place", "output": "u" }, "v": { "node": "place", "output": "v" } } } },
    "roots": { "material": { "node": "read" } } }"#;

/// Four tiles of the floor, of which two are there; where there is none it is blue, by the size of the first.
const TILED: &str = r#"{ "phenomenon": "tiled",
    "interface": { "tiles": { "type": "texture", "default": { "texture": "a.<UDIM>.png" } } },
    "nodes": {
        "here": { "type": "state" },
        "size": { "type": "image_size", "inputs": { "texture": { "interface": "tiles" } } },
        "none": { "type": "combine_color", "inputs": { "r": 0, "g": 0, "b": { "expression": "size.width / 4" } } },
        "read": { "type": "texture_lookup", "inputs": { "texture": { "interface": "tiles" },
            "u": { "expression": "2 * here.u" }, "v": { "expression": "2 * here.v" } } },
        "paint": { "type": "select", "inputs": { "condition": { "node": "read", "output": "ok" },
            "if_true": { "node": "read", "output": "color" }, "if_false": { "node": "none" } } },
        "blue": { "type": "constant_color", "inputs": { "value": [0, 0, 1] } } },
    "roots": { "material": ROOT } }"#;

fn floor(folder: &Path, filter: &str) -> Arc<Graph> {
    let mut checks = Film::new(16, 16).unwrap();
    for row in 0..16 {
        for column in 0..16 {
            let light = if (row / 8 + column / 8) % 2 == 0 { 0.0 } else { 1.0 };
            checks.set(column, row, [light, light, light, 1.0]);
        }
    }
    phenomenon_runtime::film::write(&checks, &folder.join("checks.png"), 1.0).unwrap();
    graph(folder, &FLOOR.replace("FILTER", &format!("{filter:?}")))
}

fn graph(folder: &Path, text: &str) -> Arc<Graph> {
    let file = folder.join("floor.json");
    std::fs::write(&file, text).unwrap();
    let checked = read_graph_file(&file, &NodeLibrary::standard());
    Arc::new(checked.graph.unwrap_or_else(|| panic!("{:?}", checked.findings)))
}

fn scene(graph: &Arc<Graph>, options: Options) -> Scene {
    let camera = Camera::new([0.0, 2.0, 0.0], [0.0, 1.6, -1.0], [0.0, 1.0, 0.0], 60.0).unwrap();
    seen(camera, graph, options).unwrap()
}

fn seen(camera: Camera, graph: &Arc<Graph>, options: Options) -> Result<Scene, SceneError> {
    let mut builder = SceneBuilder::new(camera);
    let none: [(String, Literal); 0] = [];
    let material =
        builder.material(Arc::new(Shader::new(Arc::clone(graph), &none, options).unwrap()));
    let corner = |x: f32, z: f32| [x, 0.0, z];
    let mesh = Mesh {
        positions: vec![
            corner(-500.0, 500.0),
            corner(500.0, 500.0),
            corner(500.0, -500.0),
            corner(-500.0, -500.0),
        ],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    builder.mesh(&mesh, &Transform::default(), material).unwrap();
    builder.build()
}

fn picture(scene: &Scene, samples: u32, threads: usize, batch: usize) -> Film {
    let settings =
        Settings { width: 48, height: 32, samples, threads, batch, ..Settings::default() };
    render(scene, &settings, &|_, _| ()).unwrap().film
}

/// How far pixels of rows stray from the mean of light and dark.
fn straying(film: &Film, rows: std::ops::Range<u32>) -> f32 {
    let pixels = rows.flat_map(|row| (0..film.width()).map(move |column| (column, row)));
    let far = pixels.map(|(column, row)| (film.pixel(column, row)[0] - 0.5).abs());
    far.fold(0.0, f32::max)
}

#[test]
fn a_chequered_floor_fades_to_its_mean() {
    let folder = tempfile::tempdir().unwrap();
    let options = || Options { engine: Engine::Batch, ..Options::default() };
    let filtered = picture(&scene(&floor(folder.path(), "footprint"), options()), 1, 1, 64);
    let raw = picture(&scene(&floor(folder.path(), "linear"), options()), 1, 1, 64);
    // The horizon is in row 3. Just below it a pixel covers many squares, near the camera a part of one.
    assert!(straying(&raw, 5..8) > 0.45, "{}", straying(&raw, 5..8));
    assert!(straying(&filtered, 5..8) < 0.1, "{}", straying(&filtered, 5..8));
    assert!(straying(&filtered, 26..32) > 0.45, "{}", straying(&filtered, 26..32));
}

#[test]
fn a_board_without_a_picture_fades_too() {
    let folder = tempfile::tempdir().unwrap();
    let board = |filter: &str, engine| {
        let graph = graph(folder.path(), &BOARD.replace("FILTER", &format!("{filter:?}")));
        picture(&scene(&graph, Options { engine, ..Options::default() }), 1, 1, 64)
    };
    let filtered = board("footprint", Engine::Batch);
    let raw = board("none", Engine::Batch);
    assert_eq!(straying(&raw, 5..8), 0.5);
    assert!(straying(&filtered, 5..8) < 0.1, "{}", straying(&filtered, 5..8));
    assert_eq!(straying(&filtered, 26..32), 0.5);
    for engine in [Engine::Walk, Engine::Jit] {
        assert!(board("footprint", engine) == filtered, "{engine:?}");
    }
}

#[test]
fn tiles_are_read_where_they_are_and_opened_only_if_read() {
    let folder = tempfile::tempdir().unwrap();
    let tile = |name: &str, color: [f32; 4]| {
        let mut film = Film::new(4, 2).unwrap();
        (0..8).for_each(|pixel| film.set(pixel % 4, pixel / 4, color));
        phenomenon_runtime::film::write(&film, &folder.path().join(name), 1.0).unwrap();
    };
    let (red, green, blue) = ([1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]);
    tile("a.1001.png", red);
    tile("a.1002.png", green);
    let reading = graph(folder.path(), &TILED.replace("ROOT", r#"{ "node": "paint" }"#));
    let idle = graph(folder.path(), &TILED.replace("ROOT", r#"{ "node": "blue" }"#));
    let from_above = || Camera::new([0.0, 500.0, 0.0], [0.0; 3], [0.0, 0.0, -1.0], 60.0).unwrap();
    let options = |engine| Options { engine, ..Options::default() };
    for engine in [Engine::Walk, Engine::Batch, Engine::Jit] {
        let film = picture(&seen(from_above(), &reading, options(engine)).unwrap(), 1, 1, 64);
        let corners = [(4, 28), (44, 28), (4, 4), (44, 4)];
        let found = corners.map(|(column, row)| film.pixel(column, row));
        assert_eq!(found, [red, green, blue, blue], "{engine:?}");
    }
    for name in ["a.1001.png", "a.1002.png"] {
        std::fs::remove_file(folder.path().join(name)).unwrap();
    }
    let film = picture(&seen(from_above(), &idle, options(Engine::Batch)).unwrap(), 1, 1, 64);
    assert_eq!(film.pixel(4, 28), blue);
    let error = seen(from_above(), &reading, options(Engine::Batch)).err().unwrap().to_string();
    assert!(error.contains("none of its tiles, such as `a.1001.png`"), "{error}");
}

#[test]
fn engines_threads_and_batches_see_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let graph = floor(folder.path(), "footprint");
    let first =
        picture(&scene(&graph, Options { engine: Engine::Walk, ..Options::default() }), 2, 1, 64);
    for (engine, threads, batch) in
        [(Engine::Batch, 2, 256), (Engine::Batch, 1, 7), (Engine::Jit, 2, 64)]
    {
        let other = picture(
            &scene(&graph, Options { engine, batch, ..Options::default() }),
            2,
            threads,
            batch,
        );
        assert!(first == other, "{engine:?} {threads} {batch}");
    }
}
