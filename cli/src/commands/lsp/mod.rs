//! `phenomenon lsp`: a language server, so that editors show findings while one types.

mod complete;
mod cursor;
mod file;
mod hover;
mod open_files;

use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response};
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::{Value, json};

use self::open_files::OpenFiles;
use crate::failure::{Failure, Outcome};

/// Talks the language server protocol over standard input and output: findings, completion of
/// types, inputs, nodes, outputs and parameters, and docs of what is under the pointer.
#[derive(Debug, clap::Args)]
pub struct Arguments {}

/// Runs the command until the client says goodbye.
pub fn run(_: &Arguments) -> Result<Outcome, Failure> {
    let (connection, threads) = Connection::stdio();
    let broken = |error: &dyn std::fmt::Display| {
        Failure::new(format!("the editor broke off: {error}"), "start the language server anew")
    };
    let capabilities = json!({
        // Whole files: they are small, and are read anew with every change anyway.
        "textDocumentSync": 1,
        "completionProvider": { "triggerCharacters": ["\"", ":", " "] },
        "hoverProvider": true,
    });
    connection.initialize(capabilities).map_err(|error| broken(&error))?;
    let mut server = Server { library: NodeLibrary::standard(), files: OpenFiles::default() };
    // An editor that just stops, or says exit without shutdown, has crashed or is about to.
    let mut outcome = Outcome::Found;
    for message in &connection.receiver {
        let answers = match message {
            Message::Request(request) => {
                if connection.handle_shutdown(&request).map_err(|error| broken(&error))? {
                    outcome = Outcome::Fine;
                    break;
                }
                vec![server.answer(request).into()]
            }
            Message::Notification(notification) => server.note(&notification),
            Message::Response(_) => Vec::new(),
        };
        for answer in answers {
            if connection.sender.send(answer).is_err() {
                break;
            }
        }
    }
    // The writing thread ends when nothing can be sent any more.
    drop(connection);
    threads.join().map_err(|error| broken(&error))?;
    Ok(outcome)
}

struct Server {
    library: NodeLibrary,
    files: OpenFiles,
}

impl Server {
    /// Takes note of an opened, changed or closed file, and yields its findings, and those of the
    /// open files that use it.
    fn note(&mut self, notification: &Notification) -> Vec<Message> {
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

    fn answer(&self, request: Request) -> Response {
        let params = &request.params;
        let file = params["textDocument"]["uri"].as_str().and_then(|uri| self.files.get(uri));
        let at = file.map(|file| file.byte_of(&params["position"]));
        let result = match (request.method.as_str(), file, at) {
            ("textDocument/completion", Some(file), Some(at)) => {
                Value::Array(complete::complete(file, at, &self.library))
            }
            ("textDocument/hover", Some(file), Some(at)) => hover::hover(file, at, &self.library),
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

fn findings_of(uri: &str, diagnostics: Vec<Value>) -> Message {
    let params = json!({ "uri": uri, "diagnostics": diagnostics });
    Notification::new("textDocument/publishDiagnostics".into(), params).into()
}
