//! A file that is open in the editor.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use lsp_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, Location,
    NumberOrString, Position, Range, Uri,
};
use phenomenon_compiler::check::check_graph_with;
use phenomenon_compiler::diagnostics::{Finding, Place, Related, Severity, SourceFile};
use phenomenon_compiler::document::{self, Document, ValueKind};
use phenomenon_compiler::nodes::NodeLibrary;
use phenomenon_runtime::link::check_with_graphs;
use phenomenon_runtime::scene_file::{Assets, is_scene};

use super::address::{names_of, path_of, uri_of};
use super::in_editor::InEditor;
use crate::ours::Ours;

/// A file, its findings, and the last form of it that was JSON.
pub struct OpenFile {
    uri: String,
    path: PathBuf,
    source: Arc<SourceFile>,
    findings: Vec<Finding>,
    /// What it is; none where it is none of ours.
    pub ours: Option<Ours>,
    /// The paths it may be known by.
    pub names: [PathBuf; 2],
    /// The paths of all files it uses, whether they exist or not.
    pub used: HashSet<PathBuf>,
    /// What was JSON last; while one types the file mostly is not.
    pub document: Option<Document>,
}

impl OpenFile {
    /// Reads and checks the text of a file; `before` is what it was, and `files` where those it uses
    /// are found, pictures by what `assets` remember of them. What is none of ours is left alone; what was ours stays so while one types.
    pub fn read(
        uri: &str,
        text: &str,
        before: Option<OpenFile>,
        library: &NodeLibrary,
        files: &InEditor<'_>,
        assets: &Assets,
    ) -> Self {
        let path = path_of(uri);
        let name = path.display().to_string();
        let read = document::read(&name, text.as_bytes());
        let now = match &read {
            Ok(document) => Ours::of(document),
            Err(_) => Ours::of_text(text),
        };
        let ours = now.or(before.as_ref().and_then(|before| before.ours));
        let (document, findings) = match read {
            _ if ours.is_none() => (None, Vec::new()),
            Ok(document) => {
                let findings = if is_scene(&document) {
                    let folder = path.parent().unwrap_or(Path::new(""));
                    check_with_graphs(&document, folder, library, files, assets)
                } else {
                    check_graph_with(&document, library, files)
                };
                (Some(document), findings.findings)
            }
            Err(finding) => {
                (before.and_then(|before| before.document), document::all_mistakes(*finding))
            }
        };
        let mut used = files.used();
        if let Some(document) = &document {
            let folder = path.parent().unwrap_or(Path::new(""));
            for file in named_files(&document.root) {
                used.extend(names_of(&folder.join(file)));
            }
        }
        let source = Arc::new(SourceFile::new(name, text));
        let names = names_of(&path);
        // It is asked for by its own name too, to tell whether it uses itself.
        for name in &names {
            used.remove(name);
        }
        Self { uri: uri.into(), path, source, findings, ours, names, used, document }
    }

    /// Its path, from its address.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder it is in.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// Its address, as the editor gives it.
    pub fn uri(&self) -> &str {
        &self.uri
    }

    /// Its address, where it is one.
    pub fn own_uri(&self) -> Option<Uri> {
        self.uri.parse().ok()
    }

    /// What it is as JSON; none while the text is none, when places would be off.
    pub fn current(&self) -> Option<&Document> {
        self.document.as_ref().filter(|document| document.file.text == self.text())
    }

    /// Bytes of the text, as the protocol counts them.
    pub fn range_of(&self, bytes: &std::ops::Range<usize>) -> Range {
        range_in(&self.source, bytes)
    }

    /// Its findings that are surely mended by a text in their place, with the text.
    pub fn fixes(&self) -> impl Iterator<Item = (Diagnostic, &str)> {
        self.findings.iter().filter_map(|finding| {
            let fix = finding.fix.as_deref()?;
            let own = finding.place.file.name == self.source.name;
            own.then(|| (self.diagnostic(finding), fix))
        })
    }

    /// Whether it uses the file with these names, or one in the folder with them.
    pub fn uses(&self, names: &[PathBuf; 2]) -> bool {
        self.used.iter().any(|used| names.iter().any(|name| used.starts_with(name)))
    }

    /// The text as it is now.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// The byte at a position, whose characters count in UTF-16.
    pub fn byte_of(&self, position: Position) -> usize {
        let mut left = position.character as usize;
        let text = self.text();
        let start = match position.line as usize {
            0 => 0,
            line => text.match_indices('\n').nth(line - 1).map_or(text.len(), |(at, _)| at + 1),
        };
        for (at, character) in text[start..].char_indices() {
            if left == 0 || character == '\n' {
                return start + at;
            }
            left = left.saturating_sub(character.len_utf16());
        }
        text.len()
    }

    /// The findings as the protocol has them.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        self.findings.iter().map(|finding| self.diagnostic(finding)).collect()
    }

    fn diagnostic(&self, finding: &Finding) -> Diagnostic {
        let own = finding.place.file.name == self.source.name;
        let message = match (own, finding.help.as_str()) {
            (false, _) => format!("in a file it uses: {finding}"),
            (true, "") => finding.message.clone(),
            (true, help) => format!("{}\n{help}", finding.message),
        };
        let range = match own {
            true => range(&finding.place),
            false => self.use_of(finding),
        };
        let severity = match finding.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
            Severity::Note => DiagnosticSeverity::INFORMATION,
        };
        let related = finding.related.iter().filter_map(|related| {
            let uri = self.uri_of(&related.place.file.name)?;
            let location = Location { uri, range: self::range(&related.place) };
            Some(DiagnosticRelatedInformation { location, message: related.message.clone() })
        });
        Diagnostic {
            range,
            severity: Some(severity),
            code: Some(NumberOrString::String(finding.code.0.into())),
            source: Some("phenomenon".into()),
            message,
            related_information: Some(related.collect()),
            tags: finding.code.is_idle().then(|| vec![DiagnosticTag::UNNECESSARY]),
            ..Diagnostic::default()
        }
    }

    /// Its address or that of a file it uses, from the name findings give it: names are Unicode, paths need not be. What
    /// the editor calls an address need not be one; then the path makes one.
    fn uri_of(&self, name: &str) -> Option<Uri> {
        if name == self.source.name
            && let Ok(own) = self.uri.parse()
        {
            return Some(own);
        }
        let known = self.used.iter().find(|path| path.display().to_string() == name);
        uri_of(known.map_or(Path::new(name), PathBuf::as_path)).parse().ok()
    }

    /// Where this file uses the one a finding is in: the place itself is in another file. At the top
    /// where it uses it through a third.
    fn use_of(&self, finding: &Finding) -> Range {
        let here = |related: &&Related| related.place.file.name == self.source.name;
        if let Some(related) = finding.related.iter().find(here) {
            return range(&related.place);
        }
        let folder = self.path().parent().unwrap_or(Path::new(""));
        let named = self.document.as_ref().and_then(|document| {
            let names =
                |name: &str| folder.join(name).display().to_string() == finding.place.file.name;
            Some(range(&document.place(name_of_file(&document.root, &names)?)))
        });
        named.unwrap_or_default()
    }
}

/// The first value of a key `file` that suits. The nesting of documents is bounded, and so is this
/// recursion.
fn name_of_file<'d>(
    value: &'d document::Value,
    suits: &impl Fn(&str) -> bool,
) -> Option<&'d document::Value> {
    match &value.kind {
        ValueKind::Array(elements) => {
            elements.iter().find_map(|element| name_of_file(element, suits))
        }
        ValueKind::Object(members) => members.iter().find_map(|member| match &member.value.kind {
            ValueKind::String(name) if member.key == "file" && suits(name) => Some(&member.value),
            _ => name_of_file(&member.value, suits),
        }),
        _ => None,
    }
}

fn range(place: &Place) -> Range {
    range_in(&place.file, &(place.start..place.end))
}

/// Bytes of a file, as the protocol counts them.
pub fn range_in(file: &SourceFile, bytes: &std::ops::Range<usize>) -> Range {
    Range { start: position(file, bytes.start), end: position(file, bytes.end) }
}

fn position(file: &SourceFile, byte: usize) -> Position {
    let byte = file.text.floor_char_boundary(byte);
    let (line, _) = file.line_column(byte);
    let start = file.text[..byte].rfind('\n').map_or(0, |at| at + 1);
    let character = file.text[start..byte].encode_utf16().count();
    // Files are far smaller than the largest number of the protocol.
    Position { line: (line - 1) as u32, character: character as u32 }
}

/// Files that are named in a document and read as they are: meshes and pictures.
fn named_files(value: &document::Value) -> Vec<&str> {
    let mut files = Vec::new();
    let mut pending = vec![value];
    while let Some(value) = pending.pop() {
        match &value.kind {
            ValueKind::Array(elements) => pending.extend(elements),
            ValueKind::Object(members) => {
                for member in members {
                    match &member.value.kind {
                        ValueKind::String(file)
                            if ["mesh", "image", "texture"].contains(&member.key.as_str()) =>
                        {
                            files.push(file.as_str());
                        }
                        _ => pending.push(&member.value),
                    }
                }
            }
            _ => {}
        }
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_in_utf_16() {
        let library = NodeLibrary::standard();
        let (files, assets) = (InEditor::default(), Assets::default());
        let text = "{\n\"😀é\": 1 }";
        let file = OpenFile::read("file:///a.json", text, None, &library, &files, &assets);
        let at = |line: u32, character: u32| file.byte_of(Position { line, character });
        assert_eq!((at(0, 0), at(0, 9), at(1, 0), at(1, 1)), (0, 1, 2, 3));
        assert_eq!((at(1, 3), at(1, 4), at(9, 9)), (7, 9, file.text().len()));
        assert_eq!(position(&file.source, 9), Position { line: 1, character: 4 });
    }
}
