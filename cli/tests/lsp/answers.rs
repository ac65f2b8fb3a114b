//! What else editors ask about a file as a whole.

use serde_json::{Value, json};

use crate::editor::{Editor, URI, uri};

const MESSY: &str = r#"{ "phenomenon": "m", "doc": "a",
"interface": { "tint": { "type": "color", "default": [1, 0.5, 0] },
 "lost": { "type": "scalar", "default": 1 } },
"nodes": { "a": { "type": "mix", "inputs": { "a": [0, 0.2158605, 1, 0.5], "b": { "interface": "tint" }, "wieght": 0.5 } },
"lonely": { "type": "light_color" }, "hot": { "type": "constant_color", "inputs": { "value": [20, 1, 1] } } },
"roots": { "material": { "node": "a" } } }"#;

fn of_file(extra: Value) -> Value {
    let mut params = json!({ "textDocument": { "uri": URI } });
    params.as_object_mut().unwrap().extend(extra.as_object().unwrap().clone());
    params
}

#[test]
fn fixes_are_actions_and_what_is_dead_is_unnecessary() {
    let mut editor = Editor::start();
    let findings = editor.open(MESSY);
    let of = |code: &str| findings.iter().find(|it| it["code"] == code).unwrap().clone();
    assert_eq!(of("unused-parameter")["tags"], json!([1]));
    assert_eq!(of("unreachable-node")["tags"], json!([1]));
    let unknown = of("unknown-input");
    assert!(unknown["tags"].is_null());
    let range = &unknown["range"];
    let params = of_file(json!({ "range": range, "context": { "diagnostics": [] } }));
    let actions = &editor.ask("textDocument/codeAction", params)["result"];
    assert_eq!(actions.as_array().unwrap().len(), 1, "{actions}");
    assert_eq!(actions[0]["title"], "Write \"weight\"");
    let edit = &actions[0]["edit"]["documentChanges"][0];
    assert_eq!((&edit["textDocument"]["uri"], &edit["edits"][0]["range"]), (&json!(URI), range));
    assert_eq!(edit["edits"][0]["newText"], "\"weight\"");
    let nowhere =
        json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 1 } });
    let params = of_file(json!({ "range": nowhere, "context": { "diagnostics": [] } }));
    assert_eq!(editor.ask("textDocument/codeAction", params)["result"], json!([]));
    editor.end();
}

#[test]
fn a_file_is_formatted_as_fmt_does_it() {
    let mut editor = Editor::start();
    editor.open(MESSY);
    let ask = of_file(json!({ "options": { "tabSize": 4, "insertSpaces": true } }));
    let edits = editor.ask("textDocument/formatting", ask.clone())["result"].clone();
    let formatted = edits[0]["newText"].as_str().unwrap().to_owned();
    assert!(formatted.starts_with("{\n  \"phenomenon\": \"m\",\n"), "{formatted}");
    editor.change(&formatted);
    assert_eq!(editor.ask("textDocument/formatting", ask.clone())["result"], json!([]));
    // What is not JSON stays as it is.
    editor.change("{ \"phenomenon\": \"m\", ");
    assert!(editor.ask("textDocument/formatting", ask)["result"].is_null());
    editor.end();
}

#[test]
fn the_outline_names_parameters_and_nodes() {
    let mut editor = Editor::start();
    editor.open(MESSY);
    let outline = &editor.ask("textDocument/documentSymbol", of_file(json!({})))["result"];
    let sections: Vec<&str> =
        outline.as_array().unwrap().iter().map(|it| it["name"].as_str().unwrap()).collect();
    assert_eq!(sections, ["interface", "nodes", "roots"]);
    let nodes = outline[1]["children"].as_array().unwrap();
    assert_eq!((&nodes[0]["name"], &nodes[0]["detail"]), (&json!("a"), &json!("mix")));
    assert_eq!(nodes.len(), 3);
    editor.end();
}

#[test]
fn colours_are_shown_as_a_screen_shows_them() {
    let mut editor = Editor::start();
    editor.open(MESSY);
    let colors = editor.ask("textDocument/documentColor", of_file(json!({})))["result"].clone();
    let colors = colors.as_array().unwrap();
    // The third is brighter than a screen; the `a` of a generic node may be a vector.
    assert_eq!(colors.len(), 1, "{colors:?}");
    let color = &colors[0]["color"];
    assert_eq!((&color["red"], &color["alpha"]), (&json!(1.0), &json!(1.0)));
    assert!((color["green"].as_f64().unwrap() - 0.7354).abs() < 1e-3, "{color}");
    let choose = |color: Value| of_file(json!({ "color": color, "range": colors[0]["range"] }));
    let mut label = |color| {
        let answer = editor.ask("textDocument/colorPresentation", choose(color));
        answer["result"][0]["label"].as_str().unwrap().to_owned()
    };
    let half = json!({ "red": 1.0, "green": 0.7353569, "blue": 0.0, "alpha": 1.0 });
    assert_eq!(label(half), "[1, 0.5, 0]");
    assert_eq!(label(json!({ "red": 0, "green": 0, "blue": 0, "alpha": 0.25 })), "[0, 0, 0, 0.25]");
    editor.end();
}

#[test]
fn colours_within_parameters_are_shown() {
    let mut editor = Editor::start();
    editor.open(
        r#"{ "phenomenon": "p", "interface": {
            "tints": { "type": "array", "of": { "type": "color" }, "default": [[1, 1, 1], [0, 0.5, 0, 1]] },
            "look": { "type": "struct", "members": { "tint": { "type": "color", "default": [0, 0, 1] },
                "axis": { "type": "vector", "default": [0, 0, 1] } } } }, "roots": {} }"#,
    );
    let colors = editor.ask("textDocument/documentColor", of_file(json!({})))["result"].clone();
    assert_eq!(colors.as_array().unwrap().len(), 3, "{colors}");
    editor.end();
}

#[test]
fn files_are_links_and_are_offered() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    std::fs::create_dir_all(folder.join("metal/old")).unwrap();
    std::fs::write(folder.join("metal/brass.json"), "{}").unwrap();
    std::fs::write(folder.join("metal/rust.png"), "").unwrap();
    let graph = folder.join("g.json");
    let text = r#"{ "phenomenon": "g", "nodes": { "n": { "type": { "file": "metal/brass.json" } }, "m": { "type": { "file": "metal/none.json" } } }, "roots": {} }"#;
    let mut editor = Editor::start();
    editor.write(&graph, text, 1);
    let params = json!({ "textDocument": { "uri": uri(&graph) } });
    let links = &editor.ask("textDocument/documentLink", params)["result"];
    assert_eq!(links.as_array().unwrap().len(), 1, "{links}");
    assert_eq!(links[0]["target"], uri(&folder.join("metal/brass.json")));
    let mut offered = |text: &str| {
        let at = text.find('|').unwrap();
        editor.write(&graph, &text.replacen('|', "", 1), 1);
        let params = json!({ "textDocument": { "uri": uri(&graph) }, "position": { "line": 0, "character": at } });
        let items = editor.ask("textDocument/completion", params)["result"].clone();
        let items = items.as_array().unwrap().clone();
        let texts = items.iter().map(|it| it["textEdit"]["newText"].as_str().unwrap().to_owned());
        texts.collect::<Vec<_>>()
    };
    let with = |named: &str| text.replacen("metal/brass.json", named, 1);
    assert_eq!(offered(&with("m|")), ["metal/"]);
    assert_eq!(offered(&with("metal/|")), ["brass.json", "old/"]);
    let texture = r#"{ "phenomenon": "g", "nodes": { "n": { "type": "texture_lookup", "inputs": { "texture": { "texture": "metal/r|" } } } }, "roots": {} }"#;
    assert_eq!(offered(texture), ["old/", "rust.png"]);
    editor.end();
}

#[test]
fn tokens_tell_what_names_are() {
    let mut editor = Editor::start();
    let text = "{ \"phenomenon\": \"g\", \"nodes\": {\n  \"é\": { \"type\": \"add\", \"inputs\": { \"a\": 1, \"b\": 2 } } },\n  \"roots\": { \"material\": { \"node\": \"é\" } } }";
    editor.open(text);
    let answer = editor.ask("textDocument/semanticTokens/full", of_file(json!({})));
    let data: Vec<u64> = answer["result"]["data"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it.as_u64().unwrap())
        .collect();
    let tokens: Vec<&[u64]> = data.chunks(5).collect();
    let expected: [&[u64]; 5] = [
        &[1, 3, 1, 1, 1],
        &[0, 15, 3, 2, 0],
        &[0, 19, 1, 3, 0],
        &[0, 8, 1, 3, 0],
        &[1, 36, 1, 1, 0],
    ];
    assert_eq!(tokens, expected);
    editor.end();
}

#[test]
fn files_that_are_not_ours_are_left_alone() {
    let mut editor = Editor::start();
    assert!(editor.open(r#"{ "name": "x", "nodes": { "a": {} } }"#).is_empty());
    for method in
        ["documentSymbol", "formatting", "documentColor", "documentLink", "semanticTokens/full"]
    {
        let answer = editor.ask(&format!("textDocument/{method}"), of_file(json!({})));
        assert!(answer["error"].is_null() && answer["result"].is_null(), "{method}: {answer}");
    }
    editor.end();
}
