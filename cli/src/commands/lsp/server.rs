//! The conversation with an editor.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidCloseTextDocument, DidOpenTextDocument,
    DidSaveTextDocument, Initialized, Notification as _, PublishDiagnostics,
};
use lsp_types::request::{
    Completion, HoverRequest, Initialize, RegisterCapability, Request as _, Shutdown,
};
use lsp_types::{
    CompletionOptions, Diagnostic, DidChangeWatchedFilesClientCapabilities,
    DidChangeWatchedFilesRegistrationOptions, FileSystemWatcher, GlobPattern,
    HoverProviderCapability, InitializeResult, Position, Registration, RegistrationParams,
    ServerCapabilities, ServerInfo, TextDocumentContentChangeEvent, TextDocumentSyncCapability,
    TextDocumentSyncKind, TextDocumentSyncOptions, TextDocumentSyncSaveOptions,
};
use phenomenon_compiler::nodes::NodeLibrary;
use serde::de::DeserializeOwned;
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
            (Initialized::METHOD, _) if self.watches => return watch_files().into_iter().collect(),
            (DidChangeWatchedFiles::METHOD, _) => {
                let changes = params["changes"].as_array().map_or(&[][..], Vec::as_slice);
                let uris: Vec<&str> =
                    changes.iter().filter_map(|change| change["uri"].as_str()).collect();
                self.files.changed_on_disk(&uris, library)
            }
            (DidOpenTextDocument::METHOD, Some(uri)) => {
                let text = params["textDocument"]["text"].as_str();
                text.map_or(Vec::new(), |text| self.files.change(uri, text, library))
            }
            (DidChangeTextDocument::METHOD, Some(uri)) => {
                let changes =
                    of_type::<Vec<TextDocumentContentChangeEvent>>(&params["contentChanges"]);
                let last = changes.as_ref().and_then(|changes| changes.last());
                last.map_or(Vec::new(), |last| self.files.change(uri, &last.text, library))
            }
            (DidSaveTextDocument::METHOD, Some(uri)) => self.files.saved(uri, library),
            (DidCloseTextDocument::METHOD, Some(uri)) => {
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
            (Stage::Greeting, Initialize::METHOD) => {
                self.stage = Stage::Working;
                let watching =
                    &request.params["capabilities"]["workspace"]["didChangeWatchedFiles"];
                self.watches = of_type::<DidChangeWatchedFilesClientCapabilities>(watching)
                    .is_some_and(|watching| watching.dynamic_registration == Some(true));
                Response::new_ok(request.id, capabilities())
            }
            (Stage::Greeting, _) => {
                refused(request.id, ErrorCode::ServerNotInitialized, "`initialize` comes first")
            }
            (Stage::Working, Shutdown::METHOD) => {
                self.stage = Stage::Leaving;
                Response::new_ok(request.id, Value::Null)
            }
            (Stage::Working, Initialize::METHOD) => {
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
        let at = of_type::<Position>(&params["position"]);
        match (request.method.as_str(), file.zip(at)) {
            (Completion::METHOD, Some((file, at))) => {
                let at = file.byte_of(at);
                let items = complete::complete(file, at, &self.library, &self.files);
                Response::new_ok(request.id, items)
            }
            (HoverRequest::METHOD, Some((file, at))) => {
                let at = file.byte_of(at);
                Response::new_ok(request.id, hover::hover(file, at, &self.library, &self.files))
            }
            // Nothing is known of a file that is not open, and of places that are none.
            (Completion::METHOD | HoverRequest::METHOD, None) => {
                Response::new_ok(request.id, Value::Null)
            }
            (method, _) => {
                let message = format!("`{method}` is not known here");
                Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message)
            }
        }
    }
}

/// A part of a message, where it is what the protocol says. The addresses of files are read as they stand: editors send
/// some that `lsp_types::Uri` refuses, and they must be answered with the very same.
fn of_type<T: DeserializeOwned>(part: &Value) -> Option<T> {
    T::deserialize(part).ok()
}

fn capabilities() -> InitializeResult {
    let sync = TextDocumentSyncOptions {
        open_close: Some(true),
        // Whole files: they are small, and are read anew with every change anyway.
        change: Some(TextDocumentSyncKind::FULL),
        save: Some(TextDocumentSyncSaveOptions::Supported(true)),
        ..TextDocumentSyncOptions::default()
    };
    let completion = CompletionOptions {
        trigger_characters: Some(["\"", ":", " "].map(str::to_owned).to_vec()),
        ..CompletionOptions::default()
    };
    InitializeResult {
        capabilities: ServerCapabilities {
            text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
            completion_provider: Some(completion),
            hover_provider: Some(HoverProviderCapability::Simple(true)),
            ..ServerCapabilities::default()
        },
        server_info: Some(ServerInfo {
            name: "phenomenon".into(),
            version: Some(env!("CARGO_PKG_VERSION").into()),
        }),
    }
}

/// Asks the editor to tell of changes on disk: of graphs and scenes, and of what they are made of.
fn watch_files() -> Option<Message> {
    let watchers = ["json", "obj", "png", "jpg", "jpeg", "exr", "hdr"].map(|ending| {
        let glob_pattern = GlobPattern::String(format!("**/*.{ending}"));
        FileSystemWatcher { glob_pattern, kind: None }
    });
    let options = DidChangeWatchedFilesRegistrationOptions { watchers: watchers.to_vec() };
    let registration = Registration {
        id: "files".into(),
        method: DidChangeWatchedFiles::METHOD.into(),
        register_options: Some(serde_json::to_value(options).ok()?),
    };
    let params = RegistrationParams { registrations: vec![registration] };
    let id = RequestId::from("watch-files".to_owned());
    Some(Request::new(id, RegisterCapability::METHOD.into(), params).into())
}

fn findings_of(uri: &str, diagnostics: Vec<Diagnostic>) -> Message {
    let params = json!({ "uri": uri, "diagnostics": diagnostics });
    Notification::new(PublishDiagnostics::METHOD.into(), params).into()
}
