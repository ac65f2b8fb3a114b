//! Meshes as they are found, from the file to the picture.

use crate::program::{Folder, printed, refused, run};

const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

/// A folder with a scene of one white mesh, seen from the front.
fn folder(mesh: &str) -> (Folder, String) {
    let folder = Folder::new();
    folder.file("mesh.obj", mesh);
    folder.file("white.json", r#"{"phenomenon": "white", "roots": {"material": [1, 1, 1]}}"#);
    let scene = folder.file(
        "scene.json",
        r#"{"scene": "s", "camera": {"position": [0, 0, 10], "look_at": [0, 0, 0], "field_of_view": 11.421186274999286},
            "objects": [{"mesh": "mesh.obj", "material": {"file": "white.json"}}],
            "options": {"size": [8, 8], "samples": 1}}"#,
    );
    (folder, scene)
}

#[test]
fn triangles_without_area_are_noted_and_nothing_else_changes() {
    let (folder, scene) = folder(&format!("{SQUARE}f 1 2 3 4\n{}", "f 1 1 1\n".repeat(65)));
    let checked = printed(&["check", &scene]);
    assert!(checked.contains("flat-triangles") && checked.contains("65 triangles"), "{checked}");
    let silent = printed(&["check", &scene, "--allow", "flat-triangles"]);
    assert!(!silent.contains("65 triangles"), "{silent}");
    let (noted, plain) = (folder.path("noted.exr"), folder.path("plain.exr"));
    let render = run(&["render", &scene, "-o", &noted]);
    assert_eq!(render.code, Some(0), "{render:?}");
    assert!(render.complaint.contains("65 triangles"), "{}", render.complaint);
    folder.file("mesh.obj", format!("{SQUARE}f 1 2 3 4\n"));
    let render = run(&["render", &scene, "-o", &plain]);
    assert_eq!((render.code, render.complaint.contains("flat")), (Some(0), false), "{render:?}");
    printed(&["compare", &noted, &plain, "--tolerance", "0"]);
}

#[test]
fn a_line_that_is_refused_is_named_by_check_and_render() {
    for (rest, part) in [
        ("vt nan 0\nf 1/1 2/1 3/1\n", "mesh.obj:5: `nan`"),
        ("f 1 2 3\nf 1 2 7\n", "mesh.obj:6: `7`"),
        ("f 1 1 1\n", "no triangle of it has an area (1 without)"),
    ] {
        let (_folder, scene) = folder(&format!("{SQUARE}{rest}"));
        let check = run(&["check", &scene, "--format", "json"]);
        assert_eq!(check.code, Some(1), "{check:?}");
        assert!(check.output.contains(part), "{}", check.output);
        refused(&["render", &scene], &["unusable-file"]);
    }
}

#[test]
fn many_objects_in_one_place_are_rendered() {
    let (folder, _) = folder(&format!("{SQUARE}f 1 2 3 4\n"));
    let object = r#"{"mesh": "mesh.obj", "material": {"file": "white.json"}}"#;
    let objects = vec![object; 500].join(",");
    let scene = folder.file(
        "many.json",
        format!(
            r#"{{"scene": "s", "camera": {{"position": [0, 0, 10], "look_at": [0, 0, 0]}}, "objects": [{objects}],
                "options": {{"size": [4, 4], "samples": 1}}}}"#
        ),
    );
    let render = run(&["render", &scene, "-o", &folder.path("many.exr")]);
    assert_eq!(render.code, Some(0), "{render:?}");
}
