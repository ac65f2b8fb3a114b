//! What commands write: whole or not at all, and over nothing that was read.

use std::path::{Path, PathBuf};

use phenomenon_compiler::document::opened_files;
use phenomenon_runtime::outputs::{self, FileIdentity, WriteError};

use crate::failure::Failure;

/// A file to be written, and the flag that names it.
#[derive(Clone, Copy, Debug)]
pub struct Output<'a> {
    /// Such as `-o`.
    pub flag: &'a str,
    /// The file.
    pub path: &'a Path,
}

impl Output<'_> {
    /// Fails if the file could not be written; leaves what is there as it is. Asked before long work,
    /// so that no render is lost to a misspelt folder.
    ///
    /// # Errors
    /// Why it could not be written.
    pub fn require_writable(self) -> Result<(), Failure> {
        outputs::require_writable(self.path).map_err(|error| self.refused(&error))
    }

    /// Writes the file.
    ///
    /// # Errors
    /// It cannot be written; what was there is untouched.
    pub fn write(self, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
        outputs::write(self.path, bytes.as_ref()).map_err(|error| self.refused(&error))
    }

    fn refused(self, error: &WriteError) -> Failure {
        let message = format!("{} {}: {}", self.flag, self.path.display(), error.cause);
        Failure::new(message, error.cause.help())
    }
}

/// Writes a file anew that was an argument.
///
/// # Errors
/// It cannot be written; what was there is untouched.
pub fn rewrite(path: &Path, text: &str) -> Result<(), Failure> {
    outputs::write(path, text.as_bytes()).map_err(|error| Failure::new(&error, error.cause.help()))
}

/// Fails if one of the files to be written is one that was read, or another of them, however the two
/// are spelt. Asked after all was read and before the work starts.
///
/// # Errors
/// Two that are one file.
pub fn require_apart(outputs: &[Output<'_>]) -> Result<(), Failure> {
    let read: Vec<(PathBuf, FileIdentity)> = opened_files()
        .into_iter()
        .filter_map(|path| FileIdentity::of(&path).map(|identity| (path, identity)))
        .collect();
    for (at, output) in outputs.iter().enumerate() {
        let (flag, path) = (output.flag, output.path.display());
        let Some(identity) = FileIdentity::of(output.path) else { continue };
        if let Some((read, _)) = read.iter().find(|(_, read)| *read == identity) {
            let message = format!("{flag} {path} would replace {}, which was read", read.display());
            return Err(Failure::new(message, format!("name another file with {flag}")));
        }
        let same = |other: &&Output<'_>| FileIdentity::of(other.path).as_ref() == Some(&identity);
        if let Some(other) = outputs[..at].iter().find(same) {
            let (other_flag, other) = (other.flag, other.path.display());
            let message = format!("{other_flag} {other} and {flag} {path} are the same file");
            return Err(Failure::new(message, "give each a file of its own"));
        }
    }
    Ok(())
}
