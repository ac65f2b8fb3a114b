//! Messages over standard input and output. What is no message is answered as such, and the next
//! one is read: an editor's slip must not end its language server.

use std::io::{self, BufRead, Read, Write};

use lsp_server::{ErrorCode, Message};
use phenomenon_compiler::document::MAX_FILE_BYTES;
use serde_json::json;

/// Longest message. A file within its own limit fits, even with every character escaped.
const MAX_MESSAGE_BYTES: u64 = 7 * MAX_FILE_BYTES as u64;
/// Longest line of a header.
const MAX_HEADER_BYTES: u64 = 4096;

/// What was read.
#[derive(Debug)]
pub enum Received {
    /// A message.
    Message(Message),
    /// Something else, and why it is no message.
    Malformed(String),
    /// The editor has closed the connection.
    End,
}

/// Reads a message.
///
/// # Errors
/// The connection broke.
pub fn receive(input: &mut impl BufRead) -> io::Result<Received> {
    let Some(length) = length(input)? else { return Ok(Received::End) };
    if length > MAX_MESSAGE_BYTES {
        io::copy(&mut input.take(length), &mut io::sink())?;
        return Ok(Received::Malformed(format!("more than {MAX_MESSAGE_BYTES} bytes")));
    }
    let mut text = Vec::new();
    if (input.take(length).read_to_end(&mut text)? as u64) < length {
        return Ok(Received::End);
    }
    Ok(match serde_json::from_slice(&text) {
        Ok(message) => Received::Message(message),
        Err(error) => Received::Malformed(error.to_string()),
    })
}

/// The length the next header gives; lines that are no header are passed over.
fn length(input: &mut impl BufRead) -> io::Result<Option<u64>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.take(MAX_HEADER_BYTES).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        match (line.trim_end(), length) {
            ("", Some(length)) => return Ok(Some(length)),
            (line, _) => {
                let header = line.split_once(':');
                let number = header
                    .filter(|(name, _)| name.trim().eq_ignore_ascii_case("Content-Length"))
                    .and_then(|(_, number)| number.trim().parse().ok());
                length = number.or(length);
            }
        }
    }
}

/// Answers what was no message.
///
/// # Errors
/// The connection broke.
pub fn refuse(output: &mut impl Write, why: &str) -> io::Result<()> {
    let error =
        json!({ "code": ErrorCode::ParseError as i32, "message": format!("no message: {why}") });
    let text = json!({ "jsonrpc": "2.0", "id": null, "error": error }).to_string();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_message_is_passed_over() {
        let frame = |text: &str| format!("Content-Length: {}\r\n\r\n{text}", text.len());
        let mut bytes = b"\xff\xfe nonsense\r\n\r\nContent-Length: -1\r\n\r\n".to_vec();
        bytes.extend(frame("{").bytes());
        bytes.extend(frame("{\"jsonrpc\": \"2.0\", \"method\": 5}").bytes());
        bytes.extend(b"content-length:2\nX-Other: 9\n\n[]");
        bytes.extend(frame("\u{0}").bytes());
        bytes.extend(frame("{ \"method\": \"exit\" }").bytes());
        bytes.extend(b"Content-Length: 18446744073709551615\r\n\r\nshort");
        let mut input = bytes.as_slice();
        for _ in 0..4 {
            assert!(matches!(receive(&mut input), Ok(Received::Malformed(_))));
        }
        assert!(matches!(
            receive(&mut input),
            Ok(Received::Message(Message::Notification(it))) if it.method == "exit"
        ));
        assert!(matches!(receive(&mut input), Ok(Received::Malformed(_))), "never allocated");
        assert!(matches!(receive(&mut input), Ok(Received::End)));
        let mut cut = &b"Content-Length: 9\r\n\r\n{}"[..];
        assert!(matches!(receive(&mut cut), Ok(Received::End)));
        let mut endless = io::repeat(b'x').take(100 << 20);
        let mut endless = io::BufReader::new(&mut endless);
        assert!(matches!(receive(&mut endless), Ok(Received::End)));
    }
}
