//! The files of one input.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use phenomenon_compiler::check::Files;
use phenomenon_compiler::diagnostics::{Code, Finding, Place, SourceFile};
use phenomenon_compiler::document::{Document, read};

/// What separates the files of an input. No JSON holds it.
pub const SEPARATOR: u8 = 0;

/// The files of an input: `0.json` is the one checked, `1.json` the one after it …
pub struct InMemory<'b>(Vec<&'b [u8]>);

impl<'b> InMemory<'b> {
    /// The files of an input, at least one.
    pub fn of(bytes: &'b [u8]) -> Self {
        Self(bytes.split(|byte| *byte == SEPARATOR).collect())
    }

    /// The bytes of the first.
    pub fn first(&self) -> &'b [u8] {
        self.0[0]
    }
}

impl Files for InMemory<'_> {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        let name = path.display().to_string();
        let known = name.strip_suffix(".json").and_then(|number| number.parse::<usize>().ok());
        match known.and_then(|at| self.0.get(at)) {
            Some(bytes) => read(&name, bytes),
            None => {
                let file = Arc::new(SourceFile::new(name, ""));
                let place = Place { file, start: 0, end: 0, path: String::new() };
                let help = "an input has only its own files";
                Err(Box::new(Finding::new(Code::UNREADABLE_FILE, place, "no such file", help)))
            }
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        path.components().filter(|part| part.as_os_str() != ".").collect()
    }

    /// Pictures are there or not by the length of their name.
    fn unusable(&self, path: &Path) -> Option<String> {
        (path.as_os_str().len() % 2 == 0).then(|| "no such picture".to_owned())
    }
}
