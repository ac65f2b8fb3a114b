//! The conversation with an editor.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidCloseTextDocument, DidOpenTextDocument,
    DidSaveTextDocument, Initialized, Notification as _, PublishDiagnostics,
};
use lsp_types::request::{
    CodeActionRequest, ColorPresentationRequest, Completion, DocumentColor,
    DocumentHighlightRequest, DocumentLinkRequest, DocumentSymbolRequest, Formatting,
    GotoDefinition, HoverRequest, Initialize, PrepareRenameRequest, References, RegisterCapability,
    Rename, Request as _, SemanticTokensFullRequest, Shutdown,
};
use lsp_types::{
    CodeActionKind, CodeActionOptions, CodeActionProviderCapability, Color,
    ColorProviderCapability, CompletionOptions, Diagnostic,
    DidChangeWatchedFilesClientCapabilities, DidChangeWatchedFilesRegistrationOptions,
    DocumentLinkOptions, FileSystemWatcher, GlobPattern, HoverProviderCapability, InitializeResult,
    OneOf, Position, Registration, RegistrationParams, RenameOptions, SemanticTokens,
    SemanticTokensFullOptions, SemanticTokensLegend, SemanticTokensOptions, ServerCapabilities,
    ServerInfo, TextDocumentContentChangeEvent, TextDocumentSyncCapability, TextDocumentSyncKind,
    TextDocumentSyncOptions, TextDocumentSyncSaveOptions, WorkDoneProgressOptions,
};
use phenomenon_compiler::nodes::NodeLibrary;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::file::OpenFile;
use super::open_files::OpenFiles;
use super::{answers, complete, hover};

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

    /// Answers a request about an open file. Nothing is known of files that are not open, and of places that are none.
    fn look_up(&self, request: Request) -> Response {
        let params = &request.params;
        let uri = params["textDocument"]["uri"].as_str();
        let file = uri.and_then(|uri| self.files.get(uri));
        if !KNOWN.contains(&request.method.as_str()) {
            let message = format!("`{}` is not known here", request.method);
            return Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message);
        }
        let Some(file) = file else { return Response::new_ok(request.id, Value::Null) };
        if file.ours.is_none() {
            let nothing =
                if request.method == Completion::METHOD { json!([]) } else { Value::Null };
            return Response::new_ok(request.id, nothing);
        }
        match self.of_file(&request.method, params, file) {
            Ok(answer) => Response::new_ok(request.id, answer),
            Err(why) => Response::new_err(request.id, ErrorCode::InvalidParams as i32, why),
        }
    }

    /// The answer to a request about a file; in words why there is none.
    fn of_file(&self, method: &str, params: &Value, file: &OpenFile) -> Result<Value, String> {
        let (library, files) = (&self.library, &self.files);
        let answer = match method {
            Formatting::METHOD => json!(answers::formatting(file)),
            DocumentSymbolRequest::METHOD => json!(answers::symbols(file)),
            DocumentLinkRequest::METHOD => json!(answers::links(file)),
            DocumentColor::METHOD => json!(answers::colors(file, library, files)),
            ColorPresentationRequest::METHOD => {
                json!(of_type::<Color>(&params["color"]).map(answers::presentations))
            }
            SemanticTokensFullRequest::METHOD => {
                let data = answers::tokens(file);
                json!(data.map(|data| SemanticTokens { result_id: None, data }))
            }
            CodeActionRequest::METHOD => {
                json!(of_type(&params["range"]).map(|range| answers::actions(file, range)))
            }
            _ => match of_type::<Position>(&params["position"]) {
                Some(position) => return self.of_place(method, params, file, position),
                None => Value::Null,
            },
        };
        Ok(answer)
    }

    /// The answer to a request about a place in a file.
    fn of_place(
        &self,
        method: &str,
        params: &Value,
        file: &OpenFile,
        position: Position,
    ) -> Result<Value, String> {
        let (library, files) = (&self.library, &self.files);
        let at = file.byte_of(position);
        let answer = match method {
            Completion::METHOD => json!(complete::complete(file, at, library, files)),
            HoverRequest::METHOD => json!(hover::hover(file, at, library, files)),
            GotoDefinition::METHOD => json!(answers::definition(file, at, files)),
            References::METHOD => {
                let with_declaration = params["context"]["includeDeclaration"] == true;
                json!(answers::references(file, at, with_declaration))
            }
            DocumentHighlightRequest::METHOD => json!(answers::highlights(file, at)),
            PrepareRenameRequest::METHOD => json!(answers::prepare(file, at)),
            Rename::METHOD => {
                let new = params["newName"].as_str().unwrap_or_default();
                json!(answers::rename(file, at, new, files)?)
            }
            _ => Value::Null,
        };
        Ok(answer)
    }
}

/// The requests about files that are answered.
const KNOWN: [&str; 14] = [
    Completion::METHOD,
    HoverRequest::METHOD,
    GotoDefinition::METHOD,
    References::METHOD,
    DocumentHighlightRequest::METHOD,
    PrepareRenameRequest::METHOD,
    Rename::METHOD,
    Formatting::METHOD,
    DocumentSymbolRequest::METHOD,
    DocumentLinkRequest::METHOD,
    DocumentColor::METHOD,
    ColorPresentationRequest::METHOD,
    SemanticTokensFullRequest::METHOD,
    CodeActionRequest::METHOD,
];

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
    let actions = CodeActionOptions {
        code_action_kinds: Some(vec![CodeActionKind::QUICKFIX]),
        ..CodeActionOptions::default()
    };
    let (kinds, modifiers) = answers::LEGEND;
    let tokens = SemanticTokensOptions {
        legend: SemanticTokensLegend {
            token_types: kinds.to_vec(),
            token_modifiers: modifiers.to_vec(),
        },
        full: Some(SemanticTokensFullOptions::Bool(true)),
        ..SemanticTokensOptions::default()
    };
    InitializeResult {
        capabilities: ServerCapabilities {
            text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
            completion_provider: Some(completion),
            hover_provider: Some(HoverProviderCapability::Simple(true)),
            definition_provider: Some(OneOf::Left(true)),
            references_provider: Some(OneOf::Left(true)),
            document_highlight_provider: Some(OneOf::Left(true)),
            document_symbol_provider: Some(OneOf::Left(true)),
            document_formatting_provider: Some(OneOf::Left(true)),
            rename_provider: Some(OneOf::Right(RenameOptions {
                prepare_provider: Some(true),
                work_done_progress_options: WorkDoneProgressOptions::default(),
            })),
            code_action_provider: Some(CodeActionProviderCapability::Options(actions)),
            color_provider: Some(ColorProviderCapability::Simple(true)),
            document_link_provider: Some(DocumentLinkOptions {
                resolve_provider: Some(false),
                work_done_progress_options: WorkDoneProgressOptions::default(),
            }),
            semantic_tokens_provider: Some(tokens.into()),
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
