//! Scene files.

use std::path::Path;
use std::sync::Arc;

use phenomenon_compiler::diagnostics::Code;
use phenomenon_compiler::engine::Shade;
use phenomenon_runtime::scene_file::{
    BuildError, MaterialSource, SceneFile, ShapeDescription, default_scene, embedded_file,
    read_scene, read_scene_file,
};

use crate::shaders::normals;

fn read(text: &str) -> SceneFile {
    read_scene("test.json", text.as_bytes(), Path::new("."))
}

fn codes(file: &SceneFile) -> Vec<(Code, String)> {
    file.findings.iter().map(|finding| (finding.code, finding.place.path.clone())).collect()
}

#[test]
fn the_default_scene_is_whole() {
    let file = default_scene();
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let scene = file.scene.unwrap();
    assert!(scene.has_subject());
    assert_eq!((scene.options.width, scene.options.height, scene.options.samples), (512, 512, 16));
    for material in scene.materials() {
        if let MaterialSource::File(path) = &material.source {
            assert!(embedded_file(path).is_some(), "{} is not built in", path.display());
        }
    }
    let built = scene.build::<()>(|_| Ok(normals() as Arc<dyn Shade>)).unwrap();
    // Three balls, and two triangles of the floor.
    assert_eq!(built.primitive_count(), 5);
}

#[test]
fn the_teapot_scene_reads_its_mesh_and_names_existing_graphs() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/teapot.json");
    let file = read_scene_file(&path);
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let scene = file.scene.unwrap();
    let ShapeDescription::Mesh(mesh) = &scene.objects[0].shape else { panic!("no mesh") };
    assert!(mesh.triangles.len() > 10_000);
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    for material in scene.materials() {
        let MaterialSource::File(path) = &material.source else { continue };
        assert!(path.exists(), "{}", path.display());
    }
}

#[test]
fn every_mistake_is_found_in_one_run() {
    let file = read(
        r#"{ "scene": "s",
        "camera": { "position": [0, 0, 1], "look_at": [0, 0, 1], "fov": 40 },
        "objects": [
            { "sphere": { "radius": -1 }, "material": { "subject": true } },
            { "mesh": "absent.obj", "material": { "file": "a.json", "set": { "a": {} } } },
            { "sphere": { "radius": 1 }, "transform": { "scale": [1, 2, 1] }, "material": {} },
            { "material": { "file": "a.json" } }
        ],
        "lights": [
            { "name": "a", "point": { "position": [0, 1] } },
            { "name": "b", "directional": { "direction": [0, 0, 0] } },
            { "name": "c" }
        ],
        "environment": { "image": "absent.hdr" },
        "options": { "size": [0, 10], "samples": 2.5, "trace_depth": [1, 2, 3, 4] } }"#,
    );
    assert!(file.scene.is_none());
    let found = codes(&file);
    let expected = [
        (Code::UNUSABLE_OBJECT, "camera"),
        (Code::UNKNOWN_KEY, "camera.fov"),
        (Code::NUMBER_OUT_OF_RANGE, "objects[0].sphere.radius"),
        (Code::UNREADABLE_FILE, "objects[1].mesh"),
        (Code::UNUSABLE_OBJECT, "objects[2].transform"),
        (Code::UNUSABLE_OBJECT, "objects[2].material"),
        (Code::UNUSABLE_OBJECT, "objects[3]"),
        (Code::WRONG_KIND, "lights[0].point.position"),
        (Code::UNUSABLE_OBJECT, "lights[1].directional"),
        (Code::UNUSABLE_OBJECT, "lights[2]"),
        (Code::UNREADABLE_FILE, "environment.image"),
        (Code::NUMBER_OUT_OF_RANGE, "options.size[0]"),
    ];
    for (code, path) in expected {
        assert!(found.contains(&(code, path.to_owned())), "{path} is missing in {found:#?}");
    }
}

#[test]
fn settings_are_kept_as_written_with_their_places() {
    let file = read(
        r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] },
        "objects": [ { "name": "ball", "sphere": { "radius": 1 }, "material": { "file": "g.json",
            "set": { "tint": [0.5, 1, 2e-1], "on": true, "mode": "screen", "ior": 1.50 } } } ] }"#,
    );
    assert!(file.findings.is_empty(), "{:?}", file.findings);
    let scene = file.scene.unwrap();
    let material = &scene.objects[0].material;
    assert_eq!(material.source, MaterialSource::File("./g.json".into()));
    let set: Vec<_> = material.set.iter().map(|s| (s.name.as_str(), s.place.text())).collect();
    let expected =
        [("tint", "[0.5, 1, 2e-1]"), ("on", "true"), ("mode", "\"screen\""), ("ior", "1.50")];
    assert_eq!(set, expected);
    assert!(material.set[0].place.path.ends_with("set.tint"));
    assert_eq!(material.change, None);
    assert!(matches!(scene.build(|_| Err("no")), Err(BuildError::Material("no"))));
}

#[test]
fn graphs_and_broken_files_are_no_scenes() {
    let graph = read(r#"{ "phenomenon": "a", "roots": { "material": 1 } }"#);
    assert_eq!(graph.findings[0].code, Code::NOT_A_SCENE);
    assert_eq!(read("{ \"scene\": ").findings.len(), 1);
    let meshes = std::env::temp_dir().join(format!("phenomenon-scene-{}", std::process::id()));
    std::fs::create_dir_all(&meshes).unwrap();
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (name, text) in [
        ("empty.obj", String::new()),
        ("nan.obj", format!("{vertices}v nan 0 0\nf 1 2 4\n")),
        ("far.obj", format!("{vertices}v 1e20 0 0\nf 1 2 4\n")),
        ("index.obj", format!("{vertices}f 1 2 9\n")),
        ("noise.obj", "\u{1}\u{2} f f f\nf x y z".to_owned()),
    ] {
        std::fs::write(meshes.join(name), text).unwrap();
        let scene = format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }},
            "objects": [ {{ "mesh": "{name}", "material": {{ "subject": true }} }} ] }}"#
        );
        let file = read_scene("test.json", scene.as_bytes(), &meshes);
        assert_eq!(codes(&file), [(Code::UNUSABLE_FILE, "objects[0].mesh".into())], "{name}");
    }
}
