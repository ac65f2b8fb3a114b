//! The files open in the editor. Files they use are read from the editor too, where they are open
//! there: what one types counts before it is saved.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use phenomenon_compiler::check::{Files, OnDisk};
use phenomenon_compiler::diagnostics::Finding;
use phenomenon_compiler::document::{self, Document};
use phenomenon_compiler::nodes::NodeLibrary;
use serde_json::Value;

use super::file::{OpenFile, path_of};

/// Findings for a file, by its address.
type Findings = (String, Vec<Value>);

/// The open files, by address.
#[derive(Default)]
pub struct OpenFiles {
    files: BTreeMap<String, OpenFile>,
}

impl OpenFiles {
    /// The file at an address.
    pub fn get(&self, uri: &str) -> Option<&OpenFile> {
        self.files.get(uri)
    }

    /// The file at a path: as it was JSON last in the editor, or else as it is on disk.
    pub fn document(&self, path: &Path) -> Option<Document> {
        let identity = OnDisk.identity(path);
        match self.files.values().find(|file| file.identity == identity) {
            Some(file) => file.document.clone(),
            None => OnDisk.read(path).ok(),
        }
    }

    /// Takes the new text of a file; yields its findings and those of the files that use it.
    pub fn change(&mut self, uri: &str, text: &str, library: &NodeLibrary) -> Vec<Findings> {
        let before = self.files.remove(uri);
        let mut findings = vec![self.check(uri, text, before, library)];
        findings.extend(self.check_users(uri, library));
        findings
    }

    /// Forgets a file; yields the findings of the files that use it, now as it is on disk.
    pub fn close(&mut self, uri: &str, library: &NodeLibrary) -> Vec<Findings> {
        self.files.remove(uri);
        self.check_users(uri, library)
    }

    fn check(
        &mut self,
        uri: &str,
        text: &str,
        before: Option<OpenFile>,
        library: &NodeLibrary,
    ) -> Findings {
        let texts = self.files.values().map(|file| (file.identity.clone(), file.text())).collect();
        let in_editor = InEditor { texts, used: RefCell::default() };
        let mut file = OpenFile::read(uri, text, before, library, &in_editor);
        file.used = in_editor.used.into_inner();
        let findings = file.diagnostics();
        self.files.insert(uri.to_owned(), file);
        (uri.to_owned(), findings)
    }

    fn check_users(&mut self, uri: &str, library: &NodeLibrary) -> Vec<Findings> {
        let changed = OnDisk.identity(&path_of(uri));
        let uses = |(_, file): &(&String, &OpenFile)| file.used.contains(&changed);
        let users: Vec<String> = self
            .files
            .iter()
            .filter(uses)
            .map(|(user, _)| user.clone())
            .filter(|user| user != uri)
            .collect();
        users
            .into_iter()
            .filter_map(|user| {
                let before = self.files.remove(&user)?;
                let text = before.text().to_owned();
                Some(self.check(&user, &text, Some(before), library))
            })
            .collect()
    }
}

/// Files as the editor has them, or else as they are on disk.
struct InEditor<'a> {
    texts: BTreeMap<PathBuf, &'a str>,
    /// What was asked for.
    used: RefCell<HashSet<PathBuf>>,
}

impl Files for InEditor<'_> {
    fn read(&self, path: &Path) -> Result<Document, Box<Finding>> {
        match self.texts.get(&self.identity(path)) {
            Some(text) => document::read(&path.display().to_string(), text.as_bytes()),
            None => OnDisk.read(path),
        }
    }

    fn identity(&self, path: &Path) -> PathBuf {
        let identity = OnDisk.identity(path);
        self.used.borrow_mut().insert(identity.clone());
        identity
    }

    fn unusable(&self, path: &Path) -> Option<String> {
        OnDisk.unusable(path)
    }
}
