//! `phenomenon lsp`, spoken to as an editor would.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

struct Editor {
    server: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    requests: u64,
}

fn uri(path: &Path) -> String {
    format!("file://{}", path.display())
}

const URI: &str = "file:///folder/a%20graph.json";

impl Editor {
    fn start() -> Self {
        let mut editor = Self::start_silently();
        let answer = editor.ask("initialize", json!({ "capabilities": {} }));
        assert_eq!(answer["result"]["capabilities"]["textDocumentSync"], 1);
        editor.tell("initialized", json!({}));
        editor
    }

    /// Without the greeting.
    fn start_silently() -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_phenomenon"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let input = server.stdin.take().unwrap();
        let output = BufReader::new(server.stdout.take().unwrap());
        Self { server, input, output, requests: 0 }
    }

    fn send(&mut self, message: &Value) {
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        self.input.flush().unwrap();
    }

    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "the server ended");
            if line == "\r\n" {
                break;
            }
            if let Some(number) = line.strip_prefix("Content-Length: ") {
                length = number.trim().parse().unwrap();
            }
        }
        let mut text = vec![0; length];
        self.output.read_exact(&mut text).unwrap();
        serde_json::from_slice(&text).unwrap()
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.requests += 1;
        self.send(
            &json!({ "jsonrpc": "2.0", "id": self.requests, "method": method, "params": params }),
        );
        let answer = self.receive();
        assert_eq!(answer["id"], self.requests);
        answer
    }

    /// Opens the file with that text, and yields its findings.
    fn open(&mut self, text: &str) -> Vec<Value> {
        self.tell("textDocument/didOpen", json!({ "textDocument": { "uri": URI, "languageId": "json", "version": 1, "text": text } }));
        self.findings()
    }

    /// Changes the whole text, and yields the findings.
    fn change(&mut self, text: &str) -> Vec<Value> {
        self.tell("textDocument/didChange", json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": text }] }));
        self.findings()
    }

    fn findings(&mut self) -> Vec<Value> {
        let message = self.receive();
        assert_eq!(message["method"], "textDocument/publishDiagnostics");
        assert_eq!(message["params"]["uri"], URI);
        message["params"]["diagnostics"].as_array().unwrap().clone()
    }

    /// Asks about the place of the bar in `text`, which is what the file becomes without it.
    fn at_bar(&mut self, method: &str, text: &str) -> Value {
        let at = text.find('|').unwrap();
        self.change(&text.replacen('|', "", 1));
        let line = text[..at].matches('\n').count();
        let start = text[..at].rfind('\n').map_or(0, |at| at + 1);
        let character = text[start..at].encode_utf16().count();
        let place = json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": character } });
        self.ask(method, place)["result"].clone()
    }

    fn labels(&mut self, text: &str) -> Vec<String> {
        let items = self.at_bar("textDocument/completion", text);
        let items = items.as_array().unwrap_or_else(|| panic!("{items}"));
        items.iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
    }

    fn hover(&mut self, text: &str) -> String {
        let answer = self.at_bar("textDocument/hover", text);
        answer["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    fn end(mut self) {
        assert!(self.ask("shutdown", Value::Null)["error"].is_null());
        self.tell("exit", Value::Null);
        assert_eq!(self.server.wait().unwrap().code(), Some(0));
    }

    /// Opens a file, or changes its text; yields the findings of that many files, by file name.
    fn write(&mut self, path: &Path, text: &str, answers: usize) -> BTreeMap<String, Vec<Value>> {
        self.tell("textDocument/didOpen", json!({ "textDocument": { "uri": uri(path), "languageId": "json", "version": 1, "text": text } }));
        self.published(answers)
    }

    fn close(&mut self, path: &Path, answers: usize) -> BTreeMap<String, Vec<Value>> {
        self.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri(path) } }));
        self.published(answers)
    }

    fn published(&mut self, answers: usize) -> BTreeMap<String, Vec<Value>> {
        let mut published = BTreeMap::new();
        for _ in 0..answers {
            let message = self.receive();
            assert_eq!(message["method"], "textDocument/publishDiagnostics");
            let uri = message["params"]["uri"].as_str().unwrap();
            let name = uri.rsplit('/').next().unwrap().to_owned();
            let findings = message["params"]["diagnostics"].as_array().unwrap().clone();
            assert!(published.insert(name, findings).is_none(), "{message}");
        }
        published
    }

    /// Sends bytes that need not be a message.
    fn send_bytes(&mut self, bytes: &[u8]) {
        self.input.write_all(bytes).unwrap();
        self.input.flush().unwrap();
    }
}

const GRAPH: &str = r#"{
  "phenomenon": "a",
  "interface": { "tint": { "type": "color", "default": [1, 0, 0], "doc": "the é😀 colour" } },
  "nodes": {
    "mirror": { "type": "trace_reflection" },
    "shade": { "type": "mix", "inputs": { "weight": 0.5, "a": { "interface": "tint" }, "b": { "node": "mirror", "output": "color" } } }
  },
  "roots": { "material": { "node": "shade" } }
}"#;

#[test]
fn findings_live_while_one_types() {
    let mut editor = Editor::start();
    assert!(editor.open(GRAPH).is_empty());
    let found = editor
        .change(&GRAPH.replace("\"doc\": \"the é😀 colour\"", "\"doc\": \"é😀\", \"mni\": 0"));
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["code"], "unknown-key");
    assert_eq!(found[0]["severity"], 1);
    // Characters of the protocol are UTF-16: é is one of them, 😀 two.
    assert_eq!(
        found[0]["range"],
        json!({ "start": { "line": 2, "character": 80 }, "end": { "line": 2, "character": 85 } })
    );
    assert!(found[0]["message"].as_str().unwrap().contains("did you mean `min`?"));
    let found = editor.change(&GRAPH[..GRAPH.len() - 3]);
    assert_eq!(found[0]["code"], "syntax");
    assert!(editor.change(GRAPH).is_empty());
    editor.tell("textDocument/didClose", json!({ "textDocument": { "uri": URI } }));
    assert!(editor.findings().is_empty());
    editor.end();
}

#[test]
fn names_are_completed_in_unfinished_files() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let types = editor.labels(&GRAPH.replace("\"trace_reflection\"", "\"tra|"));
    assert!(types.iter().any(|it| it == "trace_refraction") && types.len() > 40, "{types:?}");
    let inputs = editor.labels(&GRAPH.replace("\"weight\": 0.5", "\"|"));
    assert_eq!(inputs, ["weight", "a", "b"]);
    let nodes = editor.labels(&GRAPH.replace("\"node\": \"mirror\"", "\"node\": \"|"));
    assert_eq!(nodes, ["mirror", "shade"]);
    let outputs = editor.labels(&GRAPH.replace("\"output\": \"color\"", "\"output\": \"|"));
    assert_eq!(outputs, ["color", "ok", "hit", "distance"]);
    let parameters =
        editor.labels(&GRAPH.replace("{ \"interface\": \"tint\" }", "{ \"interface\": |"));
    assert_eq!(parameters, ["tint"]);
    let roots = editor.labels(&GRAPH.replace("\"material\"", "\"|"));
    assert!(roots.contains(&"shadow".to_owned()));
    // Outside of a string the quotes are put in, within one they are there.
    let item = |editor: &mut Editor, written: &str| {
        let text = GRAPH.replace("\"node\": \"mirror\"", &format!("\"node\": {written}"));
        editor.at_bar("textDocument/completion", &text)[0].clone()
    };
    let bare = item(&mut editor, "|");
    assert_eq!(
        (&bare["insertText"], &bare["detail"]),
        (&json!("\"mirror\""), &json!("trace_reflection"))
    );
    assert_eq!(item(&mut editor, "\"mi|")["insertText"], "mirror");
    let keys = editor.labels("{ \"|");
    assert!(keys.contains(&"phenomenon".to_owned()));
    assert!(editor.labels("|").is_empty());
    editor.end();
}

#[test]
fn docs_are_told_where_the_pointer_is() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    let mix = editor.hover(&GRAPH.replace("\"mix\"", "\"m|ix\""));
    for part in [
        "**mix** (color)",
        "Linear mix `a (1 - weight) + b weight`",
        "Inputs: `weight` scalar, `a` scalar | vector | color",
        "Outputs: `result`",
        "Source: mental ray base shaders, mib_color_mix",
    ] {
        assert!(mix.contains(part), "{part} is missing in {mix}");
    }
    let weight = editor.hover(&GRAPH.replace("\"weight\"", "\"wei|ght\""));
    assert!(weight.starts_with("`weight` scalar") && weight.contains("Range: 0 to 1"), "{weight}");
    assert!(editor.hover(&GRAPH.replace("\"weight\"", "\"wei|ght\"")).contains("Share of `b`"));
    assert!(
        editor
            .hover(&GRAPH.replace("\"node\": \"mirror\"", "\"node\": \"mir|ror\""))
            .contains("**trace_reflection**")
    );
    assert!(
        editor
            .hover(&GRAPH.replace("\"interface\": \"tint\"", "\"interface\": \"ti|nt\""))
            .contains("the é😀 colour")
    );
    assert_eq!(editor.hover(&GRAPH.replace("\"roots\"", "\"ro|ots\"")), "");
    editor.end();
}

#[test]
fn what_is_not_known_is_an_error_and_no_end() {
    let mut editor = Editor::start();
    let answer = editor.ask("textDocument/rename", json!({ "textDocument": { "uri": URI } }));
    assert!(answer["error"]["message"].as_str().unwrap().contains("textDocument/rename"));
    let place = json!({ "textDocument": { "uri": "file:///never/opened" }, "position": { "line": 9, "character": 9 } });
    assert!(editor.ask("textDocument/hover", place)["result"].is_null());
    editor.tell("textDocument/didChange", json!({ "nonsense": [] }));
    editor.open("{");
    editor.end();
}

/// Characters of the protocol are UTF-16, whatever stands before them on the line.
#[test]
fn places_count_in_utf_16_on_lines_that_are_not_ascii() {
    let mut editor = Editor::start();
    let graph = |name: &str, shade: &str| {
        format!(
            "{{ \"phenomenon\": \"a\", \"doc\": \"é😀語\", \"nodes\": {{ \"{name}\": {{ \"type\": \"mix\" }} }}, \"roots\": {{ \"material\": {shade} }} }}"
        )
    };
    editor.open(&graph("n", "1"));
    let shade = "{ \"node\": \"n|\" }";
    assert!(editor.hover(&graph("n", shade)).contains("**mix**"));
    assert_eq!(editor.labels(&graph("n", "{ \"node\": \"|")), ["n"]);
    let text = graph("n", "{ \"node\": \"m\" }");
    let found = editor.change(&text);
    let place = &found[0]["range"];
    let utf_16: Vec<u16> = text.encode_utf16().collect();
    let at = |end: &str| place[end]["character"].as_u64().unwrap() as usize;
    assert_eq!(String::from_utf16(&utf_16[at("start")..at("end")]).unwrap(), "\"m\"");
    // A position within a character, past a line, past the file or none at all is survived.
    for position in [
        json!({ "line": 0, "character": 31 }),
        json!({ "line": 0, "character": u64::MAX }),
        json!({ "line": u64::MAX, "character": 0 }),
        json!({ "line": -1, "character": -1 }),
        json!({ "line": "0" }),
        Value::Null,
    ] {
        for method in ["textDocument/hover", "textDocument/completion"] {
            let params = json!({ "textDocument": { "uri": URI }, "position": position });
            assert!(editor.ask(method, params)["error"].is_null(), "{position}");
        }
    }
    editor.end();
}

const INNER: &str = r#"{ "phenomenon": "inner", "doc": "A tinted mirror.",
  "interface": { "tint": { "type": "color", "default": 1, "doc": "its tint" } },
  "nodes": { "m": { "type": "trace_reflection" }, "t": { "type": "multiply", "inputs": { "a": { "node": "m" }, "b": { "interface": "tint" } } } },
  "roots": { "material": { "node": "t" } } }"#;

const OUTER: &str = r#"{ "phenomenon": "outer",
  "nodes": { "used": { "type": { "file": "inner.json" }, "inputs": { "tint": [1, 0, 0] } } },
  "roots": { "material": { "node": "used", "output": "color" } } }"#;

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
    // Texts that are no graphs at all.
    editor.open("");
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
