//! Running the program.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// What a run left behind.
#[derive(Debug)]
pub struct Run {
    pub code: Option<i32>,
    pub output: String,
    pub complaint: String,
}

/// The program with these arguments, in the folder of the workspace.
pub fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_phenomenon"));
    command.args(arguments).current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    command.stdin(Stdio::null());
    command
}

/// Runs it to its end.
pub fn run(arguments: &[&str]) -> Run {
    ended(&program(arguments).output().expect("the program starts"))
}

/// Runs it in `folder`, with `text` on standard input.
pub fn run_in(folder: &str, arguments: &[&str], text: &str) -> Run {
    let mut command = program(arguments);
    command.current_dir(folder).stdin(Stdio::piped());
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    // A program that refuses its arguments does not read.
    let _ = child.stdin.take().expect("a pipe").write_all(text.as_bytes());
    ended(&child.wait_with_output().expect("the program ends"))
}

fn ended(output: &Output) -> Run {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("the program writes UTF-8");
    Run {
        code: output.status.code(),
        output: text(&output.stdout),
        complaint: text(&output.stderr),
    }
}

/// Runs it to its end in a shell that has set a limit.
#[cfg(unix)]
pub fn limited(arguments: &[&str], limit: &str) -> Run {
    let mut command = Command::new("sh");
    command.args(["-c", &format!("{limit}; exec \"$@\""), "sh"]);
    command.arg(env!("CARGO_BIN_EXE_phenomenon")).args(arguments);
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).stdin(Stdio::null());
    let output = command.output().expect("a shell starts");
    let text = |bytes| String::from_utf8(bytes).expect("the program writes UTF-8");
    Run { code: output.status.code(), output: text(output.stdout), complaint: text(output.stderr) }
}

/// Runs it and expects exit code 2, nothing on standard output, no panic, and a complaint that
/// holds each of `parts`.
pub fn refused(arguments: &[&str], parts: &[&str]) {
    was_refused(&run(arguments), arguments, parts);
}

/// The same of a run that has ended.
pub fn was_refused(run: &Run, arguments: &[&str], parts: &[&str]) {
    assert_eq!(run.code, Some(2), "{arguments:?}: {run:?}");
    assert_eq!(run.output, "", "{arguments:?}");
    assert!(!run.complaint.contains("panicked"), "{arguments:?}: {}", run.complaint);
    for part in parts {
        assert!(run.complaint.contains(part), "{arguments:?} lacks `{part}`:\n{}", run.complaint);
    }
}

/// Runs it and expects exit code 0; what it printed.
pub fn printed(arguments: &[&str]) -> String {
    let run = run(arguments);
    assert_eq!(run.code, Some(0), "{arguments:?}: {run:?}");
    run.output
}

/// A folder for files of one test, removed at its end.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder can be made"))
    }

    /// The path of a file in it.
    pub fn path(&self, name: &str) -> String {
        let path: PathBuf = self.0.path().join(name);
        path.into_os_string().into_string().expect("the path is UTF-8")
    }

    /// Writes a file into it; its path.
    pub fn file(&self, name: &str, text: impl AsRef<[u8]>) -> String {
        let path = self.path(name);
        std::fs::write(&path, text).expect("the file can be written");
        path
    }
}
