//! `phenomenon lsp`: a language server, so that editors show findings while one types.

mod complete;
mod cursor;
mod file;
mod hover;
mod open_files;
mod parts;
mod transport;

use std::io;

use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::{Value, json};

use self::open_files::OpenFiles;
use self::transport::Received;
use crate::failure::{Failure, Outcome};

/// Talks the language server protocol over standard input and output: findings, completion of
/// types, inputs, nodes, outputs and parameters, and docs of what is under the pointer.
#[derive(Debug, clap::Args)]
pub struct Arguments {}

/// Runs the command until the client says goodbye: exit code 0 after `shutdown`, else 1.
pub fn run(_: &Arguments) -> Result<Outcome, Failure> {
    let broken = |error: io::Error| {
        Failure::new(format!("the editor broke off: {error}"), "start the language server anew")
    };
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    let mut server = Server {
        library: NodeLibrary::standard(),
        files: OpenFiles::default(),
        stage: Stage::Greeting,
    };
    loop {
        let answers = match transport::receive(&mut input).map_err(broken)? {
            Received::Message(Message::Request(request)) => vec![server.answer(request).into()],
            Received::Message(Message::Notification(note)) if note.method == "exit" => break,
            Received::Message(Message::Notification(note)) => server.note(&note),
            Received::Message(Message::Response(_)) => Vec::new(),
            Received::Malformed(why) => {
                transport::refuse(&mut output, &why).map_err(broken)?;
                continue;
            }
            Received::End => break,
        };
        for answer in answers {
            answer.write(&mut output).map_err(broken)?;
        }
    }
    Ok(if server.stage == Stage::Leaving { Outcome::Fine } else { Outcome::Found })
}

/// How far the conversation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// `initialize` is awaited.
    Greeting,
    /// Everything is answered.
    Working,
    /// After `shutdown`: only `exit` is awaited.
    Leaving,
}

struct Server {
    library: NodeLibrary,
    files: OpenFiles,
    stage: Stage,
}

impl Server {
    /// Takes note of an opened, changed or closed file, and yields its findings, and those of the
    /// open files that use it.
    fn note(&mut self, notification: &Notification) -> Vec<Message> {
        if self.stage != Stage::Working {
            return Vec::new();
        }
        let params = &notification.params;
        let Some(uri) = params["textDocument"]["uri"].as_str() else { return Vec::new() };
        let text = match notification.method.as_str() {
            "textDocument/didOpen" => params["textDocument"]["text"].as_str(),
            "textDocument/didChange" => params["contentChanges"]
                .as_array()
                .and_then(|changes| changes.last())
                .and_then(|change| change["text"].as_str()),
            "textDocument/didClose" => {
                let mut answers = vec![findings_of(uri, Vec::new())];
                let users = self.files.close(uri, &self.library);
                answers
                    .extend(users.into_iter().map(|(uri, findings)| findings_of(&uri, findings)));
                return answers;
            }
            _ => None,
        };
        let Some(text) = text else { return Vec::new() };
        let changed = self.files.change(uri, text, &self.library);
        changed.into_iter().map(|(uri, findings)| findings_of(&uri, findings)).collect()
    }

    fn answer(&mut self, request: Request) -> Response {
        let refused =
            |id, code: ErrorCode, why: &str| Response::new_err(id, code as i32, why.into());
        match (self.stage, request.method.as_str()) {
            (Stage::Greeting, "initialize") => {
                self.stage = Stage::Working;
                Response::new_ok(request.id, capabilities())
            }
            (Stage::Greeting, _) => {
                refused(request.id, ErrorCode::ServerNotInitialized, "`initialize` comes first")
            }
            (Stage::Working, "shutdown") => {
                self.stage = Stage::Leaving;
                Response::new_ok(request.id, Value::Null)
            }
            (Stage::Working, "initialize") => {
                refused(request.id, ErrorCode::InvalidRequest, "`initialize` comes once")
            }
            (Stage::Working, _) => self.look_up(request),
            (Stage::Leaving, _) => {
                refused(request.id, ErrorCode::InvalidRequest, "after `shutdown` comes `exit`")
            }
        }
    }

    fn look_up(&self, request: Request) -> Response {
        let params = &request.params;
        let uri = params["textDocument"]["uri"].as_str();
        let file = uri.and_then(|uri| self.files.get(uri));
        let at = file.map(|file| file.byte_of(&params["position"]));
        let result = match (request.method.as_str(), file, at) {
            ("textDocument/completion", Some(file), Some(at)) => {
                Value::Array(complete::complete(file, at, &self.library, &self.files))
            }
            ("textDocument/hover", Some(file), Some(at)) => {
                hover::hover(file, at, &self.library, &self.files)
            }
            ("textDocument/completion" | "textDocument/hover", ..) => Value::Null,
            (method, ..) => {
                let message = format!("`{method}` is not known here");
                let code = ErrorCode::MethodNotFound as i32;
                return Response::new_err(request.id, code, message);
            }
        };
        Response::new_ok(request.id, result)
    }
}

fn capabilities() -> Value {
    json!({
        "capabilities": {
            // Whole files: they are small, and are read anew with every change anyway.
            "textDocumentSync": 1,
            "completionProvider": { "triggerCharacters": ["\"", ":", " "] },
            "hoverProvider": true,
        },
        "serverInfo": { "name": "phenomenon", "version": env!("CARGO_PKG_VERSION") },
    })
}

fn findings_of(uri: &str, diagnostics: Vec<Value>) -> Message {
    let params = json!({ "uri": uri, "diagnostics": diagnostics });
    Notification::new("textDocument/publishDiagnostics".into(), params).into()
}
