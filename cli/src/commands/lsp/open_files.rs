//! The files open in the editor. Files they use are read from the editor too, where they are open
//! there: what one types counts before it is saved.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::Diagnostic;
use phenomenon_compiler::check::{Files, OnDisk};
use phenomenon_compiler::document::Document;
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::scene_file::Assets;

use super::address::{names_of, path_of};
use super::file::OpenFile;
use super::in_editor::InEditor;

/// Findings for a file, by its address.
type Findings = (String, Vec<Diagnostic>);

/// The open files, by address. Nothing is kept of files that are closed, and of pictures no more than whether they
/// can be used.
pub struct OpenFiles {
    files: BTreeMap<String, OpenFile>,
    assets: Assets,
}

impl Default for OpenFiles {
    fn default() -> Self {
        Self { files: BTreeMap::new(), assets: Assets::remembered() }
    }
}

impl OpenFiles {
    /// The file at an address.
    pub fn get(&self, uri: &str) -> Option<&OpenFile> {
        self.files.get(uri)
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &OpenFile> {
        self.files.values()
    }

    /// The file at a path: as it was JSON last in the editor, or else as it is on disk.
    pub fn document(&self, path: &Path) -> Option<Document> {
        let names = names_of(path);
        let known = |file: &&OpenFile| file.names.iter().any(|name| names.contains(name));
        match self.files.values().find(known) {
            Some(file) => file.document.clone(),
            None => OnDisk.read(path).ok(),
        }
    }

    /// Takes the new text of a file; yields its findings and those of the files that use it.
    pub fn change(&mut self, uri: &str, text: &str, library: &NodeLibrary) -> Vec<Findings> {
        let before = self.files.remove(uri);
        let mut findings = vec![self.check(uri, text, before, library)];
        findings.extend(self.check_users(&[path_of(uri)], Some(uri), library));
        findings
    }

    /// Forgets a file; yields the findings of the files that use it, now as it is on disk.
    pub fn close(&mut self, uri: &str, library: &NodeLibrary) -> Vec<Findings> {
        self.files.remove(uri);
        self.check_users(&[path_of(uri)], Some(uri), library)
    }

    /// A file was saved. What it uses may have changed as well, where the editor watches nothing: yields its findings
    /// and those of the files that use it.
    pub fn saved(&mut self, uri: &str, library: &NodeLibrary) -> Vec<Findings> {
        let mut findings: Vec<Findings> = self.check_again(uri, library).into_iter().collect();
        findings.extend(self.check_users(&[path_of(uri)], Some(uri), library));
        findings
    }

    /// Files were made, changed or removed on disk; yields the findings of the open files that use one of them.
    pub fn changed_on_disk(&mut self, uris: &[&str], library: &NodeLibrary) -> Vec<Findings> {
        let paths: Vec<PathBuf> = uris.iter().map(|uri| path_of(uri)).collect();
        // Written again within one tick of its clock, a file has the time it had.
        paths.iter().flat_map(|path| names_of(path)).for_each(|name| self.assets.forget(&name));
        self.check_users(&paths, None, library)
    }

    fn check(
        &mut self,
        uri: &str,
        text: &str,
        before: Option<OpenFile>,
        library: &NodeLibrary,
    ) -> Findings {
        let texts = self
            .files
            .values()
            .flat_map(|file| file.names.iter().map(move |name| (name.clone(), file.text())));
        let in_editor = InEditor::new(&path_of(uri), texts, &self.assets);
        let file = OpenFile::read(uri, text, before, library, &in_editor, &self.assets);
        let findings = file.diagnostics();
        self.files.insert(uri.to_owned(), file);
        (uri.to_owned(), findings)
    }

    fn check_again(&mut self, uri: &str, library: &NodeLibrary) -> Option<Findings> {
        let before = self.files.remove(uri)?;
        let text = before.text().to_owned();
        Some(self.check(uri, &text, Some(before), library))
    }

    /// Checks the files that use one of `changed`, but for the one at `except`.
    fn check_users(
        &mut self,
        changed: &[PathBuf],
        except: Option<&str>,
        library: &NodeLibrary,
    ) -> Vec<Findings> {
        let changed: Vec<[PathBuf; 2]> = changed.iter().map(|path| names_of(path)).collect();
        let uses = |file: &OpenFile| changed.iter().any(|names| file.uses(names));
        let users =
            self.files.iter().filter(|(uri, file)| Some(uri.as_str()) != except && uses(file));
        let users: Vec<String> = users.map(|(uri, _)| uri.clone()).collect();
        users.iter().filter_map(|user| self.check_again(user, library)).collect()
    }
}

#[cfg(test)]
mod tests {
    use lsp_types::NumberOrString;
    use phenomenon_runtime::film::{self, Film};

    use super::super::address::uri_of;
    use super::*;

    #[test]
    fn a_keystroke_reads_no_picture_and_no_mesh() {
        let folder = tempfile::tempdir().unwrap();
        let (scene, sky) = (folder.path().join("s.json"), folder.path().join("sky.hdr"));
        film::write(&Film::new(64, 32).unwrap(), &sky, 1.0).unwrap();
        std::fs::write(folder.path().join("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            .unwrap();
        let text = |doc: &str| {
            format!(
                "{{ \"scene\": \"s\", \"doc\": \"{doc}\", \"camera\": {{ \"position\": [0, 0, 5], \"look_at\": [0, 0, 0] }}, \"objects\": [{{ \"mesh\": \"a.obj\", \"material\": {{ \"subject\": true }}, \"transform\": {{ \"scale\": 2 }} }}], \"environment\": {{ \"image\": \"sky.hdr\" }} }}"
            )
        };
        let library = NodeLibrary::standard();
        let (mut files, uri) = (OpenFiles::default(), uri_of(&scene));
        for doc in ["", "a", "a s", "a sky"] {
            let findings = files.change(&uri, &text(doc), &library);
            assert!(findings[0].1.is_empty(), "{findings:?}");
        }
        assert_eq!(files.assets.reads(), 2);
        std::fs::write(&sky, "no picture").unwrap();
        let findings = files.changed_on_disk(&[&uri_of(&sky)], &library);
        let code = NumberOrString::String("unusable-file".into());
        assert_eq!(findings[0].1[0].code, Some(code));
        files.change(&uri, &text("a sky that is broken"), &library);
        assert_eq!(files.assets.reads(), 3);
    }
}
