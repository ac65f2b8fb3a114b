//! Values that are offered by the type of what they are given to.

use std::path::Path;

use serde_json::{Value, json};

use crate::editor::{Editor, uri};

/// A phenomenon with parameters of many types.
const MANY: &str = r#"{ "phenomenon": "many",
  "interface": {
    "tint": { "type": "color", "default": [1, 0.5, 0], "doc": "its tint" },
    "mode": { "type": "integer", "values": ["smooth", "rough"], "default": "smooth", "doc": "how it looks" },
    "on": { "type": "boolean", "default": false },
    "word": { "type": "string", "default": "a \"b\"" },
    "picture": { "type": "texture" },
    "lamp": { "type": "light", "default": { "light": "key" } },
    "lamps": { "type": "lights" },
    "layers": { "type": "array", "default": [{ "struct": {} }, { "struct": { "kind": "wet" } }],
      "of": { "type": "struct", "members": {
        "kind": { "type": "integer", "values": ["dry", "wet"], "default": "dry" },
        "picture": { "type": "texture", "default": null } } } } },
  "roots": { "material": { "interface": "tint" } } }"#;

/// The items offered at the bar in `text`, the text of the file at `path`.
fn items(editor: &mut Editor, path: &Path, text: &str) -> Vec<Value> {
    let at = text.find('|').unwrap();
    editor.write(path, &text.replacen('|', "", 1), 1);
    let line = text[..at].matches('\n').count();
    let character = at - text[..at].rfind('\n').map_or(0, |at| at + 1);
    let params = json!({ "textDocument": { "uri": uri(path) }, "position": { "line": line, "character": character } });
    editor.ask("textDocument/completion", params)["result"].as_array().unwrap().clone()
}

fn texts(items: &[Value], key: &str) -> Vec<String> {
    items.iter().map(|item| item[key].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn inputs_of_a_phenomenon_offer_the_words_of_its_parameters() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    std::fs::write(folder.join("many.json"), MANY).unwrap();
    let graph = folder.join("graph.json");
    let with = |inputs: &str| {
        format!(
            r#"{{ "phenomenon": "g", "nodes": {{ "n": {{ "type": {{ "file": "many.json" }}, "inputs": {{ {inputs} }} }} }},
                 "roots": {{ "material": {{ "node": "n" }} }} }}"#
        )
    };
    let mut editor = Editor::start();
    editor.write(&graph, &with(""), 1);
    let mut labels = |inputs: &str| texts(&items(&mut editor, &graph, &with(inputs)), "label");
    assert_eq!(labels(r#""mode": "|""#), ["smooth", "rough"]);
    assert_eq!(labels(r#""mode": |"#), ["smooth", "rough"]);
    assert_eq!(labels(r#""on": |"#), ["true", "false"]);
    assert!(labels(r#""on": "|""#).is_empty(), "a string is no boolean");
    assert_eq!(labels(r#""tint": |"#), ["[1, 0.5, 0]"]);
    assert_eq!(labels(r#""picture": |"#), ["{ \"texture\": \"\" }", "null"]);
    assert_eq!(labels(r#""picture": { "texture": "a.png", "space": "|" }"#), ["srgb", "linear"]);
    assert_eq!(labels(r#""layers": [{ "struct": { "kind": "|" } }]"#), ["dry", "wet"]);
    assert_eq!(labels(r#""layers": [{ "struct": { "|" } }]"#)[..2], ["kind", "picture"]);
    let keys = labels(r#""picture": { "|" }"#);
    assert_eq!(keys, ["texture", "space", "node", "output", "interface"]);
    // Other places are as they were.
    assert_eq!(labels(r#""tint": { "node": "|" }"#), ["n"]);
    let all = labels("\"|\"");
    assert!(all.starts_with(&["tint".into(), "mode".into()]) && all.len() == 8, "{all:?}");
    let items = items(&mut editor, &graph, &with("\"|\""));
    assert_eq!(items[1]["documentation"], "how it looks\n\nOne of `smooth`, `rough`");
    editor.end();
}

#[test]
fn settings_of_a_scene_offer_names_and_values_by_type() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    std::fs::write(folder.join("many.json"), MANY).unwrap();
    let scene = folder.join("scene.json");
    let with = |set: &str, around: &str| {
        format!(
            r#"{{ "scene": "s", "camera": {{ "position": [0, 0, 5], "look_at": [0, 0, 0] }},
                 "lights": [{{ "name": "key", "point": {{ "position": [0, 1, 0] }} }}, {{ "name": "fill", "point": {{ "position": [1, 1, 0] }} }}],
                 "objects": [{{ "sphere": {{ "radius": 1 }}, "material": {{ "file": "many.json", "set": {{ {set} }} }} }}]{around} }}"#
        )
    };
    let mut editor = Editor::start();
    editor.write(&scene, &with("", ""), 1);
    let mut offered =
        |set: &str, key: &str| texts(&items(&mut editor, &scene, &with(set, "")), key);
    let names = offered("\"|\"", "label");
    for name in ["tint", "mode", "layers", "layers[1]", "layers[1].kind"] {
        assert!(names.iter().any(|it| it == name), "{name} in {names:?}");
    }
    assert_eq!(offered(r#""mode": |"#, "insertText"), ["\"smooth\"", "\"rough\""]);
    assert_eq!(offered(r#""mode": "|""#, "insertText"), ["smooth", "rough"]);
    assert_eq!(offered(r#""layers[1].kind": |"#, "label"), ["dry", "wet"]);
    assert_eq!(offered(r#""layers[1]": { "struct": { "kind": "|" } }"#, "label"), ["dry", "wet"]);
    assert_eq!(offered(r#""word": |"#, "insertText"), [r#""a \"b\"""#]);
    let lamps = offered(r#""lamp": |"#, "insertText");
    assert_eq!(lamps, [r#"{ "light": "key" }"#, r#"{ "light": "fill" }"#]);
    assert_eq!(offered(r#""lamps": [{ "light": "|" }]"#, "label"), ["key", "fill"]);
    assert_eq!(offered(r#""lamps": |"#, "label")[0], r#"[{ "light": "key" }]"#);
    assert!(offered(r#""nothing": |"#, "label").is_empty());
    let around = r#", "environment": { "file": "many.json", "set": { "mode": "|" } }"#;
    assert_eq!(texts(&items(&mut editor, &scene, &with("", around)), "label"), ["smooth", "rough"]);
    editor.end();
}

/// The server completes in files as they are typed, so also where `check` would find too many parts.
#[test]
fn parts_that_multiply_leave_the_server_alive() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let elements = [r#"{ "struct": {} }"#; 16].join(", ");
    let mut declared = r#"{ "type": "scalar", "default": 0 }"#.to_owned();
    for _ in 0..8 {
        declared = format!(
            r#"{{ "type": "array", "default": [{elements}], "of": {{ "type": "struct", "members": {{ "m": {declared} }} }} }}"#
        );
    }
    let graph = format!(
        r#"{{ "phenomenon": "deep", "interface": {{ "a": {declared}, "last": {{ "type": "scalar", "default": 0 }} }}, "roots": {{ "material": 1 }} }}"#
    );
    std::fs::write(folder.join("deep.json"), graph).unwrap();
    let text = r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] },
      "objects": [{ "sphere": { "radius": 1 }, "material": { "file": "deep.json", "set": { "|" } } }] }"#;
    let mut editor = Editor::start();
    let names = texts(&items(&mut editor, &folder.join("scene.json"), text), "label");
    assert_eq!(names[..3], ["a", "last", "a[0]"]);
    assert!(names.len() < 10_000, "{}", names.len());
    editor.end();
}

#[test]
fn members_may_be_called_as_keys_are() {
    let mut editor = Editor::start();
    editor.open("{ \"phenomenon\": \"a\" }");
    let mut keys = |interface: &str| {
        editor.labels(&format!(
            r#"{{ "phenomenon": "a", "interface": {{ {interface} }}, "roots": {{ "material": 1 }} }}"#
        ))
    };
    let of_integer = keys(r#""i": { "type": "integer", "|" }"#);
    assert!(of_integer.contains(&"soft_min".into()), "{of_integer:?}");
    for name in ["of", "members", "type"] {
        let member = format!(r#""{name}": {{ "type": "integer", "|" }}"#);
        assert_eq!(keys(&member), of_integer, "{name}");
        let inner = format!(r#""s": {{ "type": "struct", "members": {{ {member} }} }}"#);
        assert_eq!(keys(&inner), of_integer, "{name}");
        let array =
            format!(r#""{name}": {{ "type": "array", "of": {{ "type": "integer", "|" }} }}"#);
        assert_eq!(keys(&array), of_integer, "{name}");
    }
    assert!(keys(r#""s": { "type": "struct", "members": { "|" } }"#).is_empty());
    editor.end();
}
