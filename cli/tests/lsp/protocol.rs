//! What is no message, or comes at the wrong time.

use serde_json::{Value, json};

use crate::GRAPH;
use crate::editor::{Editor, URI};

#[test]
fn what_is_not_known_is_an_error_and_no_end() {
    let mut editor = Editor::start();
    let answer = editor.ask("textDocument/moniker", json!({ "textDocument": { "uri": URI } }));
    assert!(answer["error"]["message"].as_str().unwrap().contains("textDocument/moniker"));
    let place = json!({ "textDocument": { "uri": "file:///never/opened" }, "position": { "line": 9, "character": 9 } });
    assert!(editor.ask("textDocument/hover", place)["result"].is_null());
    editor.tell("textDocument/didChange", json!({ "nonsense": [] }));
    editor.tell("workspace/didChangeWatchedFiles", json!({ "changes": [5, {}, { "uri": [] }] }));
    editor
        .tell("textDocument/didSave", json!({ "textDocument": { "uri": "file:///never/opened" } }));
    editor.open("{");
    editor.end();
}

#[test]
fn what_is_no_message_is_answered_and_survived() {
    let mut editor = Editor::start();
    for body in ["{", "[]", "null", "{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":7}", "\u{0}", ""] {
        editor.send_bytes(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
        let answer = editor.receive();
        assert_eq!(answer["error"]["code"], -32700, "{body}: {answer}");
        assert!(answer["id"].is_null());
    }
    editor.send_bytes(b"\xff nonsense\r\n\r\n\r\nContent-Length: x\r\n\r\n");
    for params in [
        Value::Null,
        json!([]),
        json!({ "textDocument": 5 }),
        json!({ "textDocument": { "uri": URI }, "contentChanges": {} }),
    ] {
        for method in
            ["textDocument/didOpen", "textDocument/didChange", "no/such/note", "$/cancelRequest"]
        {
            editor.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
        }
        assert!(editor.ask("textDocument/completion", params)["result"].is_null());
    }
    // Texts of a graph that are no graphs at all.
    assert!(editor.open(GRAPH).is_empty());
    for text in ["\u{feff}{}", "[[[[", "nul", "{\"nodes\": 5, \"roots\": []}", &"[".repeat(100_000)]
    {
        assert!(!editor.change(text).is_empty(), "{text}");
    }
    assert!(editor.change(GRAPH).is_empty());
    editor.end();
}

#[test]
fn the_exit_code_tells_whether_the_editor_said_goodbye() {
    let mut editor = Editor::start();
    editor.tell("exit", Value::Null);
    assert_eq!(editor.server.wait().unwrap().code(), Some(1), "no shutdown");
    let Editor { mut server, input, .. } = Editor::start();
    drop(input);
    assert_eq!(server.wait().unwrap().code(), Some(1), "the editor crashed");
    let mut editor = Editor::start();
    assert!(editor.ask("shutdown", Value::Null)["error"].is_null());
    let late = editor.ask("textDocument/hover", json!({}));
    assert_eq!(late["error"]["code"], -32600, "after shutdown nothing is answered");
    editor.tell("exit", Value::Null);
    assert_eq!(editor.server.wait().unwrap().code(), Some(0));
    let mut editor = Editor::start_silently();
    let early = editor.ask("textDocument/hover", json!({}));
    assert_eq!(early["error"]["code"], -32002, "before initialize neither");
    assert!(editor.ask("initialize", json!({}))["error"].is_null());
    assert_eq!(editor.ask("initialize", json!({}))["error"]["code"], -32600);
    editor.end();
}
