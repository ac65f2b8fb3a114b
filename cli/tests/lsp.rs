//! `phenomenon lsp`, spoken to as an editor would.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

struct Editor {
    server: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    requests: u64,
}

const URI: &str = "file:///folder/a%20graph.json";

impl Editor {
    fn start() -> Self {
        let mut server = Command::new(env!("CARGO_BIN_EXE_phenomenon"))
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let input = server.stdin.take().unwrap();
        let output = BufReader::new(server.stdout.take().unwrap());
        let mut editor = Self { server, input, output, requests: 0 };
        let answer = editor.ask("initialize", json!({ "capabilities": {} }));
        assert_eq!(answer["result"]["capabilities"]["textDocumentSync"], 1);
        editor.tell("initialized", json!({}));
        editor
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
        assert!(self.server.wait().unwrap().success());
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
    let keys = editor.labels("{ \"|");
    assert!(keys.contains(&"phenomenon".to_owned()));
    assert!(editor.labels("|").is_empty());
    editor.end();
}

#[test]
fn docs_are_told_where_the_pointer_is() {
    let mut editor = Editor::start();
    editor.open(GRAPH);
    assert!(editor.hover(&GRAPH.replace("\"mix\"", "\"m|ix\"")).contains("Linear mix"));
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
