//! Editors show us all JSON there is: what is none of ours is left alone.

use std::path::Path;

use serde_json::json;

use crate::GRAPH;
use crate::editor::Editor;

/// A file of another tool.
const PACKAGE: &str =
    r#"{ "name": "phenomenon", "version": "1.0.0", "dependencies": { "scene": "2" }, "x": {} }"#;

#[test]
fn other_json_has_no_findings_and_no_completions() {
    let mut editor = Editor::start();
    for text in [
        PACKAGE,
        &PACKAGE[..40],
        "{ \"compilerOptions\": { // comments are fine there\n } }",
        "{ \"scene\": 0, \"scenes\": [], \"asset\": { \"version\": \"2.0\" } }",
        "{ \"roots\": [\"src\"], \"testMatch\": [] }",
        "[1, 2, 3]",
        "[\"phenomenon\"",
        "",
        "{",
    ] {
        assert!(editor.open(text).is_empty(), "{text}");
        assert!(editor.change(text).is_empty(), "{text}");
    }
    for text in [&PACKAGE.replace("\"x\"", "\"|"), "{ \"|", "{ \"type\": \"|", "|"] {
        assert!(editor.labels(text).is_empty(), "{text}");
        assert_eq!(editor.hover(text), "", "{text}");
    }
    // It becomes ours by its own keys, and stays so.
    assert!(!editor.change("{ \"phenomenon\": \"a\", ").is_empty());
    assert!(editor.change(GRAPH).is_empty());
    editor.end();
}

#[test]
fn what_was_ours_stays_ours() {
    for text in [
        GRAPH,
        "{ \"scene\": \"s\", \"camera\": { \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }, \"objects\": [] }",
    ] {
        let mut editor = Editor::start();
        assert!(editor.open(text).is_empty());
        for emptied in ["", "{", "{}", "{ \"no", "nul", "[]"] {
            assert!(!editor.change(emptied).is_empty(), "{emptied}");
        }
        assert!(!editor.labels("{ \"|").is_empty());
        assert!(editor.change(text).is_empty());
        // Closed, it is forgotten: the next file of that name is another one.
        editor.tell(
            "textDocument/didClose",
            json!({ "textDocument": { "uri": crate::editor::URI } }),
        );
        assert!(editor.findings().is_empty());
        assert!(editor.open("{ \"no").is_empty());
        editor.end();
    }
}

#[test]
fn addresses_of_all_kinds_are_survived() {
    let mut editor = Editor::start();
    for uri in [
        "untitled:Untitled-1",
        "file:///caf%E9/%ff%00.json",
        "file:///a%20b/%C3%A9%F0%9F%98%80.json",
        "file:///100%/%zz%.json",
        "file:",
        "file://",
        "file:///",
        "FILE:///C:/x.json",
        "file://server/share/x.json",
        "vscode-notebook-cell:/a.json#W0sZmlsZQ%3D%3D",
        "git:/a.json?%7B%22ref%22%3A%22%22%7D",
        "é:\u{202e}",
        "",
    ] {
        let document =
            json!({ "uri": uri, "languageId": "json", "version": 1, "text": crate::OUTER });
        editor.tell("textDocument/didOpen", json!({ "textDocument": document }));
        let message = editor.receive();
        assert_eq!(message["method"], "textDocument/publishDiagnostics", "{uri}");
        assert_eq!(message["params"]["uri"], uri);
        let found = message["params"]["diagnostics"].as_array().unwrap();
        assert_eq!(found[0]["code"], "unreadable-file", "{uri}: {found:?}");
        for method in ["textDocument/hover", "textDocument/completion"] {
            let place = json!({ "textDocument": { "uri": uri }, "position": { "line": 1, "character": 40 } });
            assert!(editor.ask(method, place)["error"].is_null(), "{uri}");
        }
        editor.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri } }));
        assert_eq!(editor.receive()["params"]["diagnostics"], json!([]));
    }
    editor.end();
}

/// A path with spaces and bytes that are no Unicode, whose files use one another.
#[cfg(unix)]
#[test]
fn escaped_addresses_lead_to_their_files() {
    use std::os::unix::ffi::OsStrExt;
    let folder = tempfile::tempdir().unwrap();
    let inner_folder = folder.path().join(std::ffi::OsStr::from_bytes(b"caf\xe9 #1"));
    std::fs::create_dir(&inner_folder).unwrap();
    let (inner, outer) = (inner_folder.join("inner.json"), inner_folder.join("outer.json"));
    std::fs::write(inner, crate::INNER.replace("multiply", "mutliply")).unwrap();
    let escaped = |path: &Path| {
        let bytes = path.as_os_str().as_bytes();
        let text: String = bytes.iter().map(|byte| format!("%{byte:02X}")).collect();
        format!("file://{}", text.replace("%2F", "/"))
    };
    let mut editor = Editor::start();
    let document =
        json!({ "uri": escaped(&outer), "languageId": "json", "version": 1, "text": crate::OUTER });
    editor.tell("textDocument/didOpen", json!({ "textDocument": document }));
    let found = editor.receive()["params"]["diagnostics"].clone();
    assert_eq!(found[0]["code"], "unknown-node-type", "{found}");
    editor.end();
}
