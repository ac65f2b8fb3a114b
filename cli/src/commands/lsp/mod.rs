//! `phenomenon lsp`: a language server, so that editors show findings while one types.

mod address;
mod complete;
mod cursor;
mod file;
mod hover;
mod in_editor;
mod open_files;
mod parts;
mod scene_keys;
mod transport;

use std::io;

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
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
        watches: false,
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
    /// Whether the editor watches files for those who ask it to.
    watches: bool,
}

impl Server {
    /// Takes note of an opened, changed, saved or closed file, or of changes on disk, and yields the findings of the
    /// open files that it concerns.
    fn note(&mut self, notification: &Notification) -> Vec<Message> {
        if self.stage != Stage::Working {
            return Vec::new();
        }
        let params = &notification.params;
        let library = &self.library;
        let uri = params["textDocument"]["uri"].as_str();
        let changed = match (notification.method.as_str(), uri) {
            ("initialized", _) if self.watches => return vec![watch_files()],
            ("workspace/didChangeWatchedFiles", _) => {
                let changes = params["changes"].as_array().map_or(&[][..], Vec::as_slice);
                let uris: Vec<&str> =
                    changes.iter().filter_map(|change| change["uri"].as_str()).collect();
                self.files.changed_on_disk(&uris, library)
            }
            ("textDocument/didOpen", Some(uri)) => {
                let text = params["textDocument"]["text"].as_str();
                text.map_or(Vec::new(), |text| self.files.change(uri, text, library))
            }
            ("textDocument/didChange", Some(uri)) => {
                let changes = params["contentChanges"].as_array();
                let text = changes.and_then(|all| all.last()).and_then(|it| it["text"].as_str());
                text.map_or(Vec::new(), |text| self.files.change(uri, text, library))
            }
            ("textDocument/didSave", Some(uri)) => self.files.saved(uri, library),
            ("textDocument/didClose", Some(uri)) => {
                let mut changed = vec![(uri.to_owned(), Vec::new())];
                changed.extend(self.files.close(uri, library));
                changed
            }
            _ => Vec::new(),
        };
        changed.into_iter().map(|(uri, findings)| findings_of(&uri, findings)).collect()
    }

    fn answer(&mut self, request: Request) -> Response {
        let refused =
            |id, code: ErrorCode, why: &str| Response::new_err(id, code as i32, why.into());
        match (self.stage, request.method.as_str()) {
            (Stage::Greeting, "initialize") => {
                self.stage = Stage::Working;
                let watched = "/capabilities/workspace/didChangeWatchedFiles/dynamicRegistration";
                self.watches = request.params.pointer(watched) == Some(&Value::Bool(true));
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
            "textDocumentSync": { "openClose": true, "change": 1, "save": true },
            "completionProvider": { "triggerCharacters": ["\"", ":", " "] },
            "hoverProvider": true,
        },
        "serverInfo": { "name": "phenomenon", "version": env!("CARGO_PKG_VERSION") },
    })
}

/// Asks the editor to tell of changes on disk: of graphs and scenes, and of what they are made of.
fn watch_files() -> Message {
    let watchers = ["json", "obj", "png", "jpg", "jpeg", "exr", "hdr"]
        .map(|ending| json!({ "globPattern": format!("**/*.{ending}") }));
    let registration = json!({
        "id": "files",
        "method": "workspace/didChangeWatchedFiles",
        "registerOptions": { "watchers": watchers },
    });
    let params = json!({ "registrations": [registration] });
    let id = RequestId::from("watch-files".to_owned());
    Request::new(id, "client/registerCapability".into(), params).into()
}

fn findings_of(uri: &str, diagnostics: Vec<Value>) -> Message {
    let params = json!({ "uri": uri, "diagnostics": diagnostics });
    Notification::new("textDocument/publishDiagnostics".into(), params).into()
}
