//! Where the files come from that a phenomenon names.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::diagnostics::{Code, Finding, Place, SourceFile};
use crate::document::{Document, irregular, open_file, read_file};
use crate::values::{Tile, TilePattern, TilesError};

/// Where the files of nested phenomena come from.
pub trait Files {
    /// Reads the file at `path`, which findings call by that name.
    ///
    /// # Errors
    /// It cannot be read, or is not JSON.
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>>;

    /// The one path of a file that is reached by several.
    fn identity(&self, path: &Path) -> PathBuf;

    /// Why a file that is used as it is, such as a picture, cannot be opened; none where it can.
    fn unusable(&self, path: &Path) -> Option<String>;

    /// Why a file cannot be used as a picture, and the code for it; none where it can. Whoever knows
    /// formats of pictures looks into the file as well.
    fn unusable_picture(&self, path: &Path) -> Option<(Code, String)> {
        self.unusable(path).map(|why| (Code::UNREADABLE_FILE, why))
    }

    /// The tiles that a name stands for, with their files, by row and column; by default those on disk.
    ///
    /// # Errors
    /// There are none, or their folder cannot be read.
    fn tiles(&self, pattern: &TilePattern) -> Result<Vec<(Tile, PathBuf)>, TilesError> {
        pattern.files()
    }
}

/// Files on disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct OnDisk;

impl Files for OnDisk {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        // The place that names the file says which it is.
        match std::fs::metadata(path).ok().as_ref().and_then(irregular) {
            Some(what) => Err(no_ordinary_file(path, what)),
            None => read_file(path),
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        match open_file(path) {
            Err(error) if error.kind() == std::io::ErrorKind::IsADirectory => {
                Some("it is a folder".into())
            }
            opened => opened.err().map(|error| error.to_string()),
        }
    }
}

fn no_ordinary_file(path: &Path, what: String) -> Box<Finding> {
    let file = Arc::new(SourceFile::new(path.display().to_string(), ""));
    let place = Place { file, start: 0, end: 0, path: String::new() };
    Box::new(Finding::new(Code::UNREADABLE_FILE, place, what, "name a file"))
}
