//! The conversation with an editor.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::{Value, json};

use super::open_files::OpenFiles;
use super::{complete, hover};

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

/// What the server knows.
pub struct Server {
    library: NodeLibrary,
    files: OpenFiles,
    stage: Stage,
    /// Whether the editor watches files for those who ask it to.
    watches: bool,
}

impl Server {
    /// Before the first word.
    pub fn new() -> Self {
        Self {
            library: NodeLibrary::standard(),
            files: OpenFiles::default(),
            stage: Stage::Greeting,
            watches: false,
        }
    }

    /// Whether `shutdown` was asked for, so that the client may leave.
    pub fn is_shut_down(&self) -> bool {
        self.stage == Stage::Leaving
    }

    /// Takes note of an opened, changed, saved or closed file, or of changes on disk, and yields the findings of the
    /// open files that it concerns.
    pub fn note(&mut self, notification: &Notification) -> Vec<Message> {
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

    pub fn answer(&mut self, request: Request) -> Response {
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
