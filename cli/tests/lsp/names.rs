//! Names: where they are given and used, and what they are called from now on.

use serde_json::{Value, json};

use crate::editor::{Editor, URI, uri};

const GRAPH: &str = r#"{ "phenomenon": "g",
  "interface": { "tint": { "type": "color", "default": [1, 0.5, 0] },
    "tinted": { "type": "scalar", "default": 1 } },
  "nodes": {
    "é": { "type": "scale", "inputs": { "input": { "interface": "tint" }, "factor": { "interface": "tinted" } } },
    "sum": { "type": "add", "inputs": { "a": { "node": "é" }, "b": { "node": "é", "output": "result" } } } },
  "roots": { "material": [{ "node": "sum" }, { "node": "é" }] } }"#;

/// What the bytes of a range are in a text.
fn part<'t>(text: &'t str, range: &Value) -> &'t str {
    let byte = |position: &Value| {
        let line = position["line"].as_u64().unwrap() as usize;
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let mut left = position["character"].as_u64().unwrap() as usize;
        let mut at = start;
        for character in text[start..].chars() {
            if left == 0 {
                break;
            }
            left -= character.len_utf16();
            at += character.len_utf8();
        }
        at
    };
    &text[byte(&range["start"])..byte(&range["end"])]
}

/// Puts a bar behind the `nth` (from 0) of what stands in the graph.
fn bar(text: &str, nth: usize, what: &str) -> String {
    let (at, _) = text.match_indices(what).nth(nth).unwrap();
    format!("{}|{}", &text[..at + 1], &text[at + 1..])
}

#[test]
fn names_lead_to_where_they_are_given_and_used() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    for (nth, name) in [(0, "\"é\""), (1, "\"é\""), (3, "\"é\""), (0, "\"sum\""), (1, "\"tint\"")]
    {
        let given = editor.at_bar("textDocument/definition", &bar(GRAPH, nth, name));
        assert_eq!(given["uri"], URI);
        assert_eq!(part(GRAPH, &given["range"]), name.trim_matches('"'), "{nth} {name}");
        let first = GRAPH.find(name).unwrap();
        let line = GRAPH[..first].matches('\n').count();
        assert_eq!(given["range"]["start"]["line"], line);
    }
    let marks = editor.at_bar("textDocument/documentHighlight", &bar(GRAPH, 2, "\"é\""));
    assert_eq!(marks.as_array().unwrap().len(), 4);
    for (nth, nothing) in [(0, "\"scale\""), (0, "phenomenon"), (0, "roots")] {
        let text = bar(GRAPH, nth, nothing);
        assert!(editor.at_bar("textDocument/definition", &text).is_null(), "{nothing}");
        assert!(editor.at_bar("textDocument/prepareRename", &text).is_null(), "{nothing}");
    }
    editor.end();
}

/// The text once the edits of a file are put in.
fn edited(text: &str, edits: &Value) -> String {
    let mut edits: Vec<&Value> = edits.as_array().unwrap().iter().collect();
    edits.sort_by_key(|edit| {
        let start = &edit["range"]["start"];
        (start["line"].as_u64(), start["character"].as_u64())
    });
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        let old = part(&text, &edit["range"]);
        let at = old.as_ptr() as usize - text.as_ptr() as usize;
        let end = at + old.len();
        text.replace_range(at..end, edit["newText"].as_str().unwrap());
    }
    text
}

fn place_of(text: &str, what: &str) -> Value {
    let at = text.find(what).unwrap() + 1;
    let line = text[..at].matches('\n').count();
    let start = text[..at].rfind('\n').map_or(0, |at| at + 1);
    json!({ "line": line, "character": text[start..at].encode_utf16().count() })
}

#[test]
fn a_new_name_stands_wherever_the_old_one_stood() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mut rename = |name: &str, new: &str| {
        let params = json!({ "textDocument": { "uri": URI }, "position": place_of(GRAPH, name), "newName": new });
        editor.ask("textDocument/rename", params)
    };
    let answer = rename("\"é\"", "bright");
    let changes = &answer["result"]["documentChanges"];
    assert_eq!(changes[0]["textDocument"]["uri"], URI);
    assert_eq!(edited(GRAPH, &changes[0]["edits"]), GRAPH.replace('é', "bright"));
    // `tinted` begins with it and stays.
    let answer = rename("\"tint\"", "hue");
    let renamed = edited(GRAPH, &answer["result"]["documentChanges"][0]["edits"]);
    assert_eq!(renamed, GRAPH.replace("\"tint\"", "\"hue\""));
    for (new, why) in [
        ("sum", "`sum` is there already: choose another name"),
        ("", "the name is empty: use letters, digits, `_` and `-`, at most 256 of them"),
        (
            "a b",
            "the name has the character ' ': use letters, digits, `_` and `-`, at most 256 of them",
        ),
    ] {
        assert_eq!(rename("\"é\"", new)["error"]["message"], why);
    }
    assert_eq!(rename("\"add\"", "x")["error"]["message"], "nothing that has a name stands there");
    editor.end();
}

#[test]
fn a_parameter_is_renamed_in_the_open_files_that_set_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let inner = r#"{ "phenomenon": "i", "interface": { "look": { "type": "struct", "members": {
        "tint": { "type": "color", "default": 1 } } } },
        "nodes": { "n": { "type": "scale", "inputs": { "input": { "interface": "look.tint" }, "factor": 1 } } },
        "roots": { "material": { "node": "n" } } }"#;
    let user = r#"{ "phenomenon": "u", "nodes": { "n": { "type": { "file": "inner.json" },
        "inputs": { "look": { "struct": { "tint": 0.5 } } } }, "m": { "type": { "file": "other.json" }, "inputs": { "look": 1 } } },
        "roots": { "material": { "node": "n" } } }"#;
    let scene = r#"{ "scene": "s", "camera": { "position": [0, 0, 5], "look_at": [0, 0, 0] },
        "objects": [{ "sphere": { "radius": 1 }, "material": { "file": "inner.json", "set": { "look.tint": [1, 0, 0] } } }] }"#;
    let files = [("inner.json", inner), ("user.json", user), ("scene.json", scene)];
    let mut editor = Editor::start();
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    editor.write(&folder.join("inner.json"), inner, 1);
    editor.write(&folder.join("user.json"), user, 1);
    editor.write(&folder.join("scene.json"), scene, 1);
    let params = json!({ "textDocument": { "uri": uri(&folder.join("inner.json")) },
        "position": place_of(inner, "\"look\""), "newName": "style" });
    let answer = editor.ask("textDocument/rename", params);
    let changes = answer["result"]["documentChanges"].as_array().unwrap();
    assert_eq!(changes.len(), 3, "{answer}");
    for change in changes {
        let uri = change["textDocument"]["uri"].as_str().unwrap();
        let (name, text) = files.iter().find(|(name, _)| uri.ends_with(name)).unwrap();
        let expected = match *name {
            // The first only: the other file's parameter is another.
            "user.json" => text.replacen("\"look\"", "\"style\"", 1),
            _ => text.replace("look", "style"),
        };
        // `look_at` of the camera is no parameter.
        assert_eq!(
            edited(text, &change["edits"]),
            expected.replace("style_at", "look_at"),
            "{name}"
        );
    }
    // An input leads into the other file, and so does a setting.
    for (name, text, what) in
        [("user.json", user, "\"look\""), ("scene.json", scene, "\"look.tint\"")]
    {
        let params = json!({ "textDocument": { "uri": uri(&folder.join(name)) }, "position": place_of(text, what) });
        let given = &editor.ask("textDocument/definition", params)["result"];
        assert!(given["uri"].as_str().unwrap().ends_with("inner.json"), "{given}");
        assert_eq!(part(inner, &given["range"]), "\"look\"");
    }
    let params = json!({ "textDocument": { "uri": uri(&folder.join("user.json")) }, "position": place_of(user, "\"inner.json\"") });
    let given = &editor.ask("textDocument/definition", params)["result"];
    assert!(given["uri"].as_str().unwrap().ends_with("inner.json"), "{given}");
    editor.end();
}
