//! An editor that speaks to `phenomenon lsp`.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

/// Findings by the name of their file.
pub type Published = BTreeMap<String, Vec<Value>>;

pub struct Editor {
    pub server: Child,
    pub input: ChildStdin,
    output: BufReader<ChildStdout>,
    requests: u64,
}

pub fn uri(path: &Path) -> String {
    format!("file://{}", path.display())
}

pub const URI: &str = "file:///folder/a%20graph.json";

impl Editor {
    pub fn start() -> Self {
        let mut editor = Self::start_silently();
        let answer = editor.ask("initialize", json!({ "capabilities": {} }));
        let sync = &answer["result"]["capabilities"]["textDocumentSync"];
        assert_eq!(*sync, json!({ "openClose": true, "change": 1, "save": true }));
        editor.tell("initialized", json!({}));
        editor
    }

    /// Without the greeting.
    pub fn start_silently() -> Self {
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

    pub fn send(&mut self, message: &Value) {
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        self.input.flush().unwrap();
    }

    pub fn receive(&mut self) -> Value {
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

    pub fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        self.requests += 1;
        self.send(
            &json!({ "jsonrpc": "2.0", "id": self.requests, "method": method, "params": params }),
        );
        let answer = self.receive();
        assert_eq!(answer["id"], self.requests);
        answer
    }

    /// Opens the file with that text, and yields its findings.
    pub fn open(&mut self, text: &str) -> Vec<Value> {
        self.tell("textDocument/didOpen", json!({ "textDocument": { "uri": URI, "languageId": "json", "version": 1, "text": text } }));
        self.findings()
    }

    /// Changes the whole text, and yields the findings.
    pub fn change(&mut self, text: &str) -> Vec<Value> {
        self.tell("textDocument/didChange", json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": text }] }));
        self.findings()
    }

    pub fn findings(&mut self) -> Vec<Value> {
        let message = self.receive();
        assert_eq!(message["method"], "textDocument/publishDiagnostics");
        assert_eq!(message["params"]["uri"], URI);
        message["params"]["diagnostics"].as_array().unwrap().clone()
    }

    /// Asks about the place of the bar in `text`, which is what the file becomes without it.
    pub fn at_bar(&mut self, method: &str, text: &str) -> Value {
        let at = text.find('|').unwrap();
        self.change(&text.replacen('|', "", 1));
        let line = text[..at].matches('\n').count();
        let start = text[..at].rfind('\n').map_or(0, |at| at + 1);
        let character = text[start..at].encode_utf16().count();
        let place = json!({ "textDocument": { "uri": URI }, "position": { "line": line, "character": character } });
        self.ask(method, place)["result"].clone()
    }

    pub fn labels(&mut self, text: &str) -> Vec<String> {
        let items = self.at_bar("textDocument/completion", text);
        let items = items.as_array().unwrap_or_else(|| panic!("{items}"));
        items.iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
    }

    pub fn hover(&mut self, text: &str) -> String {
        let answer = self.at_bar("textDocument/hover", text);
        answer["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    pub fn end(mut self) {
        assert!(self.ask("shutdown", Value::Null)["error"].is_null());
        self.tell("exit", Value::Null);
        assert_eq!(self.server.wait().unwrap().code(), Some(0));
    }

    /// Opens a file, or changes its text; yields the findings of that many files, by file name.
    pub fn write(&mut self, path: &Path, text: &str, answers: usize) -> Published {
        self.tell("textDocument/didOpen", json!({ "textDocument": { "uri": uri(path), "languageId": "json", "version": 1, "text": text } }));
        self.published(answers)
    }

    pub fn close(&mut self, path: &Path, answers: usize) -> Published {
        self.tell("textDocument/didClose", json!({ "textDocument": { "uri": uri(path) } }));
        self.published(answers)
    }

    pub fn published(&mut self, answers: usize) -> Published {
        let mut published = Published::new();
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
    pub fn send_bytes(&mut self, bytes: &[u8]) {
        self.input.write_all(bytes).unwrap();
        self.input.flush().unwrap();
    }

    /// Tells of files made (1), changed (2) or removed (3) on disk; yields the findings of that many files.
    pub fn changed(&mut self, changes: &[(&Path, u8)], answers: usize) -> Published {
        let changes: Vec<Value> =
            changes.iter().map(|(path, kind)| json!({ "uri": uri(path), "type": kind })).collect();
        self.tell("workspace/didChangeWatchedFiles", json!({ "changes": changes }));
        self.published(answers)
    }

    /// Tells that a file was saved; yields the findings of that many files.
    pub fn save(&mut self, path: &Path, answers: usize) -> Published {
        self.tell("textDocument/didSave", json!({ "textDocument": { "uri": uri(path) } }));
        self.published(answers)
    }

    /// Asks for something small; what the server had to say before it would come first.
    pub fn silent(&mut self) {
        let place = json!({ "textDocument": { "uri": "file:///none" }, "position": {} });
        assert!(self.ask("textDocument/hover", place)["result"].is_null());
    }
}
