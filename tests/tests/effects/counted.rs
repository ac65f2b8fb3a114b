//! What is off is not done: rays, samples, evaluations and files are counted.

use phenomenon_compiler::engine::Options;
use phenomenon_compiler::specialise::Asking;
use phenomenon_runtime::film::{self, Film};
use phenomenon_runtime::render::{Entry, Unit};

use crate::linking::{Scene, options, root, shipped, written};

fn guarded() -> Options {
    options(Asking::Guarded)
}

/// Expects what a ledger says to be off to have cost nothing.
fn off_costs_nothing(name: &str, scene: &Scene) {
    let rendered = scene.render(12);
    for row in scene.rows.iter().filter(|row| !row.on) {
        let (count, bytes) = scene.cost(row, &rendered);
        let counts = row.entry.unit() != Unit::None;
        assert_eq!((count * u64::from(counts), bytes), (0, 0), "{name}: {row:?}");
    }
}

#[test]
fn what_is_off_costs_nothing_in_any_shipped_file() {
    let mut files = Vec::new();
    for folder in ["graphs", "scenes"] {
        for entry in walked(&root().join(folder)) {
            let path = entry.strip_prefix(root()).expect("within").display().to_string();
            let text = std::fs::read_to_string(&entry).expect("text");
            let shows = text.contains("\"subject\": true") || text.contains("\"items\"");
            if !path.contains("broken") && !path.ends_with("schema.json") && !shows {
                files.push(path);
            }
        }
    }
    assert!(files.len() > 40, "{}", files.len());
    for file in files {
        off_costs_nothing(&file, &shipped(&file, &[], guarded()));
    }
}

fn walked(folder: &std::path::Path) -> Vec<std::path::PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        match path.is_dir() {
            true => found.extend(walked(&path)),
            false if path.extension().is_some_and(|extension| extension == "json") => {
                found.push(path)
            }
            false => {}
        }
    }
    found.sort();
    found
}

#[test]
fn a_diffuse_scene_casts_no_ray_of_any_other_kind() {
    let scene = shipped("graphs/floor/checker_floor.json", &[], guarded());
    let rays = scene.render(24).statistics.rays;
    assert_eq!((rays.reflection, rays.refraction, rays.transparent, rays.probe), (0, 0, 0, 0));
    assert!(rays.eye > 0 && rays.shadow > 0);
    for entry in [Entry::Reflection, Entry::Refraction, Entry::Transparent, Entry::Probe] {
        scene.is_off(entry, &["no graph of the scene has a node that"]);
    }
}

const LAMBERT: &str = r#"{ "phenomenon": "chalk", "nodes": { "lit": { "type": "lambert" },
    "sum": { "type": "light_loop", "inputs": { "body": { "node": "lit" } } } },
    "roots": { "material": { "node": "sum" } } }"#;

fn ball(lights: &str) -> String {
    format!(
        r#"{{ "scene": "ball", "camera": {{ "position": [0, 0, 3], "look_at": [0, 0, 0] }},
        "objects": [{{ "sphere": {{ "radius": 1 }}, "material": {{ "subject": true }} }}], "lights": [{lights}] }}"#
    )
}

#[test]
fn a_scene_without_lights_runs_no_light_loop() {
    let lamp = r#"{ "name": "key", "point": { "position": [2, 4, 4] }, "color": [1, 1, 1], "intensity": 20 }"#;
    let evaluations = |lights: &str| {
        let options = Options { count: true, ..guarded() };
        let scene = written(&ball(lights), LAMBERT, &[], options);
        let rendered = scene.render(16);
        let shaders = scene.linked.shaders.iter().flat_map(|shader| shader.evaluations());
        let done: u64 = shaders.map(|(_, evaluations)| evaluations.done).sum();
        (done, rendered.statistics.points, rendered.costs.of(Entry::LightLoops).count, scene)
    };
    let (lit, points, samples, scene) = evaluations(lamp);
    scene.is_on(Entry::LightLoops, &[]);
    assert!(points > 0 && samples == points);
    let (dark, same_points, samples, scene) = evaluations("");
    scene.is_off(Entry::LightLoops, &["the scene has no lights"]);
    assert_eq!((same_points, samples), (points, 0));
    assert!(dark < lit, "no turn evaluates the body: {dark} of {lit}");
    assert_eq!(scene.render(16).statistics.rays.shadow, 0);
}

#[test]
fn parameters_at_the_value_that_removes_them_cast_nothing() {
    for (file, parameter, entry) in [
        ("graphs/glass/advanced_glass.json", ("opacity", 1.0), Entry::Refraction),
        ("graphs/sunglasses/sunglasses.json", ("refractivity", 0.0), Entry::Refraction),
        ("graphs/rainbow/rainbow.json", ("reflectivity", 0.0), Entry::Reflection),
        ("graphs/aniso/aniso_brdf.json", ("specular_reflectance", 0.0), Entry::Reflection),
        ("graphs/aniso/aniso_brdf.json", ("specular_reflectance", 0.0), Entry::SampleLoops),
        ("graphs/snow/snow.json", ("transparency", 0.0), Entry::Refraction),
    ] {
        let scene = shipped(file, &[parameter], guarded());
        let (name, value) = parameter;
        scene.is_off(entry, &[&format!("`{name}` = {value}: ")]);
        assert_eq!(scene.render(24).costs.of(entry).count, 0, "{file} {name}");
        let usual = shipped(file, &[], guarded());
        usual.is_on(entry, &[]);
        let counts = entry.unit() != Unit::None;
        assert_eq!(usual.render(24).costs.of(entry).count > 0, counts, "{file} {name}");
    }
}

#[test]
fn an_unread_texture_is_never_opened() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("spots.png");
    film::write(&Film::new(4, 2).unwrap(), &path, 1.0).unwrap();
    let graph = format!(
        r#"{{ "phenomenon": "spots",
        "interface": {{ "share": {{ "type": "scalar", "default": 0, "min": 0, "max": 1 }} }},
        "nodes": {{ "read": {{ "type": "texture_lookup", "inputs": {{ "texture": {{ "texture": {:?} }} }} }},
            "top": {{ "type": "mix", "inputs": {{ "weight": {{ "interface": "share" }}, "a": [1, 0, 0],
                "b": {{ "node": "read" }} }} }} }},
        "roots": {{ "material": {{ "node": "top" }} }} }}"#,
        path.display().to_string()
    );
    let read = written(&ball(""), &graph, &[("share", 0.5)], guarded());
    read.is_on(Entry::Texture, &["texture_lookup `read` reads it"]);
    let rendered = read.render(8);
    let (lookups, bytes) = read.cost(read.row(Entry::Texture), &rendered);
    assert_eq!(bytes, 4 * 2 * 16);
    assert!(lookups > 0);
    let all = written(&ball(""), &graph, &[], options(Asking::All));
    assert_eq!(all.cost(read.row(Entry::Texture), &all.render(8)).1, 4 * 2 * 16);
    // What stands in the file now would be refused by whoever opened it.
    std::fs::write(&path, "no picture").unwrap();
    let unread = written(&ball(""), &graph, &[], guarded());
    let row = unread.row(Entry::Texture);
    assert_eq!(row.file.as_deref(), path.to_str());
    unread.is_off(
        Entry::Texture,
        &["`share` = 0: `weight` is 0, so mix `top` (graph.json:", "never evaluates `b`"],
    );
    assert_eq!(unread.cost(row, &unread.render(8)), (0, 0));
}
