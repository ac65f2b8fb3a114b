//! The arguments of the command, and what it does.

use std::io;

use lsp_server::Message;

use super::server::Server;
use super::transport::{self, Received};
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
    let mut server = Server::new();
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
    Ok(if server.is_shut_down() { Outcome::Fine } else { Outcome::Found })
}
