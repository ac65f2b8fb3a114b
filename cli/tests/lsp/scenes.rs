//! Scenes in the editor.

use serde_json::json;

use crate::INNER;
use crate::editor::Editor;

#[test]
fn scenes_show_what_is_wrong_in_them_and_in_their_graphs() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let (graph, scene) = (folder.join("inner.json"), folder.join("scene.json"));
    let text = |set: &str| {
        format!(
            "{{ \"scene\": \"s\", \"camera\": {{ \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }}, \"objects\": [\n{{ \"sphere\": {{ \"radius\": 1 }}, \"material\": {{ \"file\": \"inner.json\", \"set\": {set} }} }}] }}"
        )
    };
    let mut editor = Editor::start();
    let found = editor.write(&scene, &text("{}"), 1);
    assert_eq!(found["scene.json"][0]["code"], "unreadable-file");
    assert_eq!(found["scene.json"][0]["range"]["start"], json!({ "line": 1, "character": 51 }));
    let found = editor.write(&graph, INNER, 2);
    assert!(found.values().all(Vec::is_empty), "{found:?}");
    let found = editor.write(&scene, &text("{ \"tnit\": 1 }"), 1);
    assert!(found["scene.json"][0]["message"].as_str().unwrap().contains("did you mean `tint`?"));
    let found = editor.write(&graph, "{", 2);
    assert_eq!(found["scene.json"][0]["code"], "syntax");
    assert_eq!(found["scene.json"][0]["range"]["start"], json!({ "line": 1, "character": 51 }));
    editor.end();
}

#[test]
fn keys_of_scenes_are_completed_and_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    std::fs::write(folder.join("inner.json"), INNER).unwrap();
    let scene = folder.join("scene.json");
    let text = "{ \"scene\": \"s\", \"camera\": { \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }, \"objects\": [\n{ \"sphere\": { \"radius\": 1 }, \"normals\": \"flat\", \"material\": { \"file\": \"inner.json\", \"set\": { \"tint\": 1 } } }], \"options\": {} }";
    let mut editor = Editor::start();
    assert!(editor.write(&scene, text, 1)["scene.json"].is_empty());
    let mut ask = |method: &str, text: &str| {
        let at = text.find('|').unwrap();
        editor.write(&scene, &text.replacen('|', "", 1), 1);
        let line = text[..at].matches('\n').count();
        let character = at - text[..at].rfind('\n').map_or(0, |at| at + 1);
        let params = json!({ "textDocument": { "uri": crate::editor::uri(&scene) }, "position": { "line": line, "character": character } });
        editor.ask(method, params)["result"].clone()
    };
    let mut labels = |text: &str| -> Vec<String> {
        let items = ask("textDocument/completion", text);
        let items = items.as_array().unwrap().iter();
        items.map(|item| item["label"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(labels(&text.replace("\"radius\": 1", "\"|")), ["center", "radius"]);
    assert_eq!(labels(&text.replace("\"flat\"", "|")), ["smooth", "flat"]);
    assert_eq!(labels(&text.replace("\"tint\": 1", "\"|")), ["tint"]);
    let options = labels(&text.replace("\"options\": {}", "\"options\": { \"|"));
    assert!(options.iter().any(|it| it == "trace_depth"), "{options:?}");
    assert!(
        labels(&text.replace("\"scene\": \"s\"", "\"scene\": \"s\", \"|"))
            .contains(&"format".to_owned())
    );
    assert!(labels(&text.replace("[0, 0, 5]", "[0, |")).is_empty());
    let told = ask("textDocument/hover", &text.replace("radius", "rad|ius"));
    let told = told["contents"]["value"].as_str().unwrap();
    assert!(told.starts_with("`radius` number, scene units, 1e-12 to 1e12"), "{told}");
    let told = ask("textDocument/hover", &text.replace("\"options\"", "\"opt|ions\""));
    assert!(told["contents"]["value"].as_str().unwrap().contains("How it is rendered"), "{told}");
}
