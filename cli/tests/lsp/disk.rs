//! Findings follow what happens on disk.

use std::path::PathBuf;

use serde_json::json;

use crate::editor::Editor;
use crate::{INNER, OUTER};

const MADE: u8 = 1;
const CHANGED: u8 = 2;
const REMOVED: u8 = 3;

fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    (folder, path)
}

#[test]
fn a_phenomenon_that_changes_is_checked_with_those_that_use_it() {
    let (_folder, folder) = folder();
    let (inner, outer, other) =
        (folder.join("inner.json"), folder.join("outer.json"), folder.join("other.json"));
    let mut editor = Editor::start();
    let found = editor.write(&outer, OUTER, 1);
    assert_eq!(found["outer.json"][0]["code"], "unreadable-file");
    // One that uses it through another, which is not open.
    let through = |file: &str| {
        OUTER.replace("inner.json", file).replace(", \"inputs\": { \"tint\": [1, 0, 0] }", "")
    };
    let far = folder.join("far.json");
    std::fs::write(&other, OUTER).unwrap();
    assert_eq!(editor.write(&far, &through("other.json"), 1)["far.json"].len(), 1);
    std::fs::write(&inner, INNER).unwrap();
    let found = editor.changed(&[(&inner, MADE)], 2);
    assert!(found.values().all(Vec::is_empty), "{found:?}");
    std::fs::write(&inner, INNER.replace("tint\"", "hue\"")).unwrap();
    let found = editor.changed(&[(&inner, CHANGED)], 2);
    assert_eq!(found["outer.json"][0]["code"], "unknown-input");
    assert_eq!(found["far.json"][0]["code"], "unknown-input");
    std::fs::remove_file(&inner).unwrap();
    let found = editor.changed(&[(&inner, REMOVED)], 2);
    assert_eq!(found["outer.json"][0]["code"], "unreadable-file");
    std::fs::write(&inner, INNER).unwrap();
    // Told twice, of two files: each user is checked once.
    let found = editor.changed(&[(&inner, REMOVED), (&inner, MADE), (&other, CHANGED)], 2);
    assert!(found.values().all(Vec::is_empty), "{found:?}");
    // What nobody uses is nothing to be said of.
    editor.changed(&[(&folder.join("unused.json"), MADE)], 0);
    editor.silent();
    // A folder that goes takes its files along.
    std::fs::remove_file(&inner).unwrap();
    let found = editor.changed(&[(&folder, REMOVED)], 2);
    assert_eq!(found["far.json"][0]["code"], "unreadable-file");
    editor.close(&far, 1);
    std::fs::write(&inner, INNER).unwrap();
    let found = editor.changed(&[(&inner, MADE)], 1);
    assert!(found["outer.json"].is_empty(), "{found:?}");
    editor.end();
}

#[test]
fn saving_checks_again_what_no_one_watched() {
    let (_folder, folder) = folder();
    let (inner, outer) = (folder.join("inner.json"), folder.join("outer.json"));
    std::fs::write(&inner, INNER).unwrap();
    let mut editor = Editor::start();
    assert!(editor.write(&outer, OUTER, 1)["outer.json"].is_empty());
    std::fs::write(&inner, INNER.replace("tint\"", "hue\"")).unwrap();
    assert_eq!(editor.save(&outer, 1)["outer.json"][0]["code"], "unknown-input");
    // The editor saves the file the other uses, too.
    editor.write(&inner, INNER, 2);
    std::fs::write(&inner, INNER).unwrap();
    let found = editor.save(&inner, 2);
    assert!(found.values().all(Vec::is_empty), "{found:?}");
    editor.end();
}

/// What one types counts, whatever is on disk.
#[test]
fn a_file_that_is_open_is_as_in_the_editor() {
    let (_folder, folder) = folder();
    let (inner, outer) = (folder.join("inner.json"), folder.join("outer.json"));
    let mut editor = Editor::start();
    editor.write(&outer, OUTER, 1);
    editor.write(&inner, INNER, 2);
    std::fs::write(&inner, "{ broken").unwrap();
    let found = editor.changed(&[(&inner, CHANGED)], 1);
    assert!(found["outer.json"].is_empty(), "{found:?}");
    let found = editor.close(&inner, 2);
    assert_eq!(found["outer.json"][0]["code"], "syntax");
    editor.end();
}

fn scene(object: &str, environment: &str) -> String {
    format!(
        "{{ \"scene\": \"s\", \"camera\": {{ \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }}, \"objects\": [{{ {object}, \"material\": {{ \"file\": \"inner.json\" }} }}], \"environment\": {{ {environment} }} }}"
    )
}

#[test]
fn scenes_follow_their_graphs_meshes_and_pictures() {
    let (_folder, folder) = folder();
    let path = |name: &str| folder.join(name);
    std::fs::write(path("inner.json"), INNER).unwrap();
    let mut editor = Editor::start();
    let text = scene("\"mesh\": \"a.obj\"", "\"image\": \"sky.png\"");
    let codes = |found: &crate::editor::Published| -> Vec<String> {
        let codes = found["s.json"].iter().map(|it| it["code"].as_str().unwrap().to_owned());
        codes.collect()
    };
    let found = editor.write(&path("s.json"), &text, 1);
    assert_eq!(codes(&found), ["unreadable-file", "unreadable-file"]);
    std::fs::write(path("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let found = editor.changed(&[(&path("a.obj"), MADE)], 1);
    assert_eq!(codes(&found), ["unreadable-file"]);
    let picture = phenomenon_runtime::film::Film::new(4, 2).unwrap();
    phenomenon_runtime::film::write(&picture, &path("sky.png"), 1.0).unwrap();
    let found = editor.changed(&[(&path("sky.png"), MADE)], 1);
    assert!(codes(&found).is_empty(), "{found:?}");
    std::fs::write(path("sky.png"), "no picture").unwrap();
    let found = editor.changed(&[(&path("sky.png"), CHANGED)], 1);
    assert_eq!(codes(&found), ["unusable-file"]);
    phenomenon_runtime::film::write(&picture, &path("sky.png"), 1.0).unwrap();
    std::fs::write(path("inner.json"), INNER.replace("multiply", "mutliply")).unwrap();
    let found = editor.changed(&[(&path("inner.json"), CHANGED)], 1);
    assert_eq!(codes(&found), ["unknown-node-type"]);
    std::fs::write(path("inner.json"), INNER).unwrap();
    std::fs::remove_file(path("a.obj")).unwrap();
    let both = [(&*path("a.obj"), REMOVED), (&*path("inner.json"), CHANGED)];
    assert_eq!(codes(&editor.changed(&both, 1)), ["unreadable-file"]);
    editor.end();
}

#[test]
fn graphs_follow_their_textures() {
    let (_folder, folder) = folder();
    let graph = folder.join("g.json");
    let text = r#"{ "phenomenon": "g",
      "interface": { "wood": { "type": "texture", "default": { "texture": "wood.png" } } },
      "nodes": { "n": { "type": "texture_lookup", "inputs": { "texture": { "interface": "wood" } } } },
      "roots": { "material": { "node": "n" } } }"#;
    let mut editor = Editor::start();
    assert_eq!(editor.write(&graph, text, 1)["g.json"][0]["code"], "unreadable-file");
    let wood = folder.join("wood.png");
    let picture = phenomenon_runtime::film::Film::new(2, 2).unwrap();
    phenomenon_runtime::film::write(&picture, &wood, 1.0).unwrap();
    assert!(editor.changed(&[(&wood, MADE)], 1)["g.json"].is_empty());
    let bytes = std::fs::read(&wood).unwrap();
    std::fs::write(&wood, &bytes[..bytes.len() / 2]).unwrap();
    let cut = editor.changed(&[(&wood, CHANGED)], 1);
    assert_eq!(cut["g.json"][0]["code"], "unusable-file");
    std::fs::remove_file(&wood).unwrap();
    assert_eq!(editor.changed(&[(&wood, REMOVED)], 1)["g.json"].len(), 1);
    editor.end();
}

#[cfg(unix)]
#[test]
fn files_reached_through_links_are_followed() {
    let (_folder, folder) = folder();
    std::fs::create_dir(folder.join("real")).unwrap();
    std::os::unix::fs::symlink(folder.join("real"), folder.join("link")).unwrap();
    let outer = folder.join("outer.json");
    let mut editor = Editor::start();
    let text = OUTER.replace("inner.json", "./link/../link/inner.json");
    assert_eq!(editor.write(&outer, &text, 1)["outer.json"].len(), 1);
    for place in ["real/inner.json", "link/inner.json"] {
        std::fs::write(folder.join(place), INNER).unwrap();
        assert!(editor.changed(&[(&folder.join(place), MADE)], 1)["outer.json"].is_empty());
        std::fs::remove_file(folder.join(place)).unwrap();
        assert_eq!(editor.changed(&[(&folder.join(place), REMOVED)], 1)["outer.json"].len(), 1);
    }
    editor.end();
}

#[test]
fn an_editor_that_can_is_asked_to_watch() {
    let mut editor = Editor::start_silently();
    let capabilities =
        json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    editor.ask("initialize", json!({ "capabilities": capabilities }));
    editor.tell("initialized", json!({}));
    let asked = editor.receive();
    assert_eq!(asked["method"], "client/registerCapability");
    let registration = &asked["params"]["registrations"][0];
    assert_eq!(registration["method"], "workspace/didChangeWatchedFiles");
    let globs = registration["registerOptions"]["watchers"].to_string();
    for ending in ["json", "obj", "png", "jpg", "jpeg", "exr", "hdr"] {
        assert!(globs.contains(&format!("**/*.{ending}\"")), "{globs}");
    }
    editor.send(&json!({ "jsonrpc": "2.0", "id": asked["id"], "result": null }));
    let (_folder, folder) = folder();
    let found = editor.write(&folder.join("a.json"), OUTER, 1);
    assert_eq!(found["a.json"].len(), 1, "it goes on after the answer");
    editor.end();
    // One that cannot is not asked: `start` of the tests is such.
    let mut editor = Editor::start();
    editor.silent();
    editor.end();
}
