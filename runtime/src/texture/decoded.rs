//! Files whose pictures are decoded, to see whether they can be.

use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::Files;
use phenomenon_compiler::diagnostics::{Code, Finding};
use phenomenon_compiler::document::Document;

use super::library::unusable;

/// Files whose pictures are decoded, each once.
pub struct DecodedPictures<'f> {
    files: &'f dyn Files,
    known: RefCell<HashMap<PathBuf, Option<(Code, String)>>>,
}

impl<'f> DecodedPictures<'f> {
    /// Those of `files`.
    pub fn of(files: &'f dyn Files) -> Self {
        Self { files, known: RefCell::default() }
    }
}

impl Files for DecodedPictures<'_> {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        self.files.read(path)
    }

    fn identity(&self, path: &Path) -> PathBuf {
        self.files.identity(path)
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        self.files.unusable(path)
    }

    fn unusable_picture(&self, path: &Path) -> Option<(Code, String)> {
        let mut known = self.known.borrow_mut();
        let found = known.entry(path.to_owned()).or_insert_with(|| {
            self.files
                .unusable_picture(path)
                .or_else(|| unusable(path).map(|error| (Code::UNUSABLE_FILE, error.to_string())))
        });
        found.clone()
    }
}
