//! Running the program, in the folder of the workspace: no path it prints is absolute.

use std::process::{Command, Stdio};

/// The folder of the workspace, from where the tests run.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// What a run left behind.
#[derive(Debug)]
pub struct Run {
    pub code: i32,
    pub output: String,
    pub complaint: String,
}

impl Run {
    /// Why it was refused, in one line.
    ///
    /// # Panics
    /// If it was not, or not in the program's own words.
    pub fn refusal(&self) -> &str {
        assert_eq!(self.code, 2, "{self:?}");
        let mut lines = self.complaint.lines();
        lines.find_map(|line| line.strip_prefix("error: ")).expect("the program says why")
    }
}

/// Runs the program to its end.
pub fn run(arguments: &[&str]) -> Run {
    let mut command = Command::new(env!("CARGO_BIN_EXE_phenomenon"));
    command.args(arguments).current_dir(ROOT).stdin(Stdio::null());
    let output = command.output().expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("the program writes UTF-8");
    Run {
        code: output.status.code().unwrap_or_else(|| panic!("{arguments:?}: {output:?}")),
        output: text(output.stdout),
        complaint: text(output.stderr),
    }
}
