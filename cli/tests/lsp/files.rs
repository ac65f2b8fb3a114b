//! Files that use one another, in the editor.

use serde_json::json;

use crate::editor::{Editor, uri};
use crate::{INNER, OUTER};

#[test]
fn files_that_use_one_another_are_checked_as_they_are_in_the_editor() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().canonicalize().unwrap();
    let (inner, outer) = (folder.join("inner.json"), folder.join("outer.json"));
    std::fs::write(&inner, INNER).unwrap();
    let mut editor = Editor::start();
    assert!(editor.write(&outer, OUTER, 1)["outer.json"].is_empty());
    // Not on disk, but open: what one types into one file shows in the other, where it is used.
    let both = editor.write(&inner, &INNER.replace("multiply", "mutliply"), 2);
    assert_eq!(both["inner.json"][0]["code"], "unknown-node-type");
    let found = &both["outer.json"][0];
    assert_eq!(found["code"], "unknown-node-type");
    assert!(found["message"].as_str().unwrap().starts_with("in a file it uses: "), "{found}");
    assert_eq!(
        found["range"],
        json!({ "start": { "line": 1, "character": 41 }, "end": { "line": 1, "character": 53 } })
    );
    let both = editor.write(&inner, &INNER.replace("tint\"", "hue\""), 2);
    assert!(both["inner.json"].is_empty(), "{both:?}");
    assert_eq!(both["outer.json"][0]["code"], "unknown-input");
    // Closed without saving: it is as on disk again.
    let both = editor.close(&inner, 2);
    assert!(both.values().all(Vec::is_empty), "{both:?}");
    // What the other file has is completed and told.
    let ask = |editor: &mut Editor, method: &str, text: &str| {
        let at = text.find('|').unwrap();
        editor.write(&outer, &text.replacen('|', "", 1), 1);
        let line = text[..at].matches('\n').count();
        let character = at - text[..at].rfind('\n').map_or(0, |at| at + 1);
        let params = json!({ "textDocument": { "uri": uri(&outer) }, "position": { "line": line, "character": character } });
        editor.ask(method, params)["result"].clone()
    };
    let items =
        ask(&mut editor, "textDocument/completion", &OUTER.replace("\"tint\": [1, 0, 0]", "\"|"));
    let expected = json!([{ "label": "tint", "kind": 5, "detail": "color", "documentation": "its tint", "insertText": "tint" }]);
    assert_eq!(items, expected);
    let items = ask(
        &mut editor,
        "textDocument/completion",
        &OUTER.replace("\"output\": \"color\"", "\"output\": \"|"),
    );
    assert_eq!((&items[0]["label"], &items[1]["label"]), (&json!("color"), &json!("ok")));
    let told = ask(&mut editor, "textDocument/hover", &OUTER.replace("inner.json", "inn|er.json"));
    assert!(told["contents"]["value"].as_str().unwrap().contains("A tinted mirror."), "{told}");
    let told = ask(&mut editor, "textDocument/hover", &OUTER.replace("\"tint\"", "\"ti|nt\""));
    assert!(told["contents"]["value"].as_str().unwrap().contains("its tint"), "{told}");
    editor.end();
}
