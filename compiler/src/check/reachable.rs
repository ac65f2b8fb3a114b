//! The files of phenomena that a document reaches, read one by one: each once, and after all those
//! it names itself. Whether it is right is no question here; circles of files and their depth are.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use crate::diagnostics::{Code, Finding, Place, shortened};
use crate::document::{Document, Value, ValueKind, all_mistakes, is_newer_format};
use crate::nodes::NodeLibrary;

use super::files::Files;
use super::limits::MAX_FILE_DEPTH;
use super::turns::unroll;

/// A file that was read, after all those it names.
pub(super) struct Reached {
    /// What it holds.
    pub content: Content,
    /// Where it is used first, and from there on outward to the document that is checked.
    pub uses: Uses,
}

/// Where a file is used first, and from there on outward.
pub(super) struct Uses(Vec<Use>);

impl Uses {
    /// A finding in the file, with the nodes that use it, innermost first.
    pub fn told_with(&self, mut finding: Finding) -> Finding {
        for Use { place, node, .. } in &self.0 {
            // A circle of files shows its uses itself.
            if finding.related.iter().any(|related| related.place == *place) {
                continue;
            }
            let message = format!("node `{}` uses the file here", shortened(node));
            finding = finding.with_related(place.clone(), message);
        }
        finding
    }
}

/// What a file holds.
pub(super) enum Content {
    /// A document, its maps and folds written out, what is wrong with those, and the files it names, as
    /// it writes them.
    Document(Document, Vec<Finding>, Named),
    /// No JSON.
    Mistakes(Vec<Finding>),
}

/// The files a document names, as it writes them.
pub(super) type Named = HashMap<String, Target>;

/// What a file that is named turned out to be.
#[derive(Clone)]
pub(super) enum Target {
    /// The file that was reached after so many others.
    Reached(usize),
    /// It must not be named, or cannot be read; told where it is named first.
    Refused(Option<Finding>),
}

/// A use of a file.
#[derive(Clone)]
struct Use {
    /// The file, as written.
    file: String,
    place: Place,
    /// The node that does.
    node: String,
}

/// A file whose own files are being read.
struct Open {
    identity: PathBuf,
    name: String,
    /// Its folder, as it is named.
    folder: PathBuf,
    /// With what is wrong with its maps and folds; none for the document that is checked, which needs no
    /// reading.
    document: Option<(Document, Vec<Finding>)>,
    /// Files it names that were not looked at yet, from the last to the first.
    waiting: Vec<Use>,
    /// The use of the next file that is open.
    using: Option<Use>,
    named: Named,
}

impl Open {
    fn new(identity: PathBuf, name: String, document: &Document) -> Self {
        let folder = Path::new(&document.file.name).parent().unwrap_or(Path::new(""));
        let (folder, waiting) = (folder.to_owned(), uses(document));
        Self { identity, name, folder, document: None, waiting, using: None, named: Named::new() }
    }
}

/// Reads what a document reaches.
pub(super) struct Reachable<'f> {
    library: &'f NodeLibrary,
    files: &'f dyn Files,
    /// The files that are open, outermost first, each the user of the next.
    open: Vec<Open>,
    /// Files that were reached, and after how many others; none where one cannot be read.
    known: HashMap<PathBuf, Option<usize>>,
    /// How many were reached.
    count: usize,
}

impl<'f> Reachable<'f> {
    /// What `document` reaches.
    pub fn from(document: &Document, library: &'f NodeLibrary, files: &'f dyn Files) -> Self {
        let name = document.file.name.clone();
        let open = vec![Open::new(files.identity(Path::new(&name)), name, document)];
        Self { library, files, open, known: HashMap::new(), count: 0 }
    }

    /// The next file; none once all were read.
    pub fn next(&mut self) -> Option<Reached> {
        loop {
            let innermost = self.open.last_mut()?;
            match innermost.waiting.pop() {
                Some(using) => {
                    if let Some(broken) = self.follow(using) {
                        return Some(broken);
                    }
                }
                None if self.open.len() == 1 => return None,
                None => return self.leave(),
            }
        }
    }

    /// What the document itself names, once all files were read.
    pub fn into_named(mut self) -> Named {
        self.open.pop().map(|document| document.named).unwrap_or_default()
    }

    /// Opens a file that is named, unless there is a reason not to. One that is no JSON is reached at
    /// once.
    fn follow(&mut self, using: Use) -> Option<Reached> {
        let user = self.open.last_mut()?;
        let path = user.folder.join(&using.file);
        let identity = self.files.identity(&path);
        if let Some(finding) = self.refusal(&using, &identity) {
            self.name(using.file, Target::Refused(Some(finding)));
            return None;
        }
        if let Some(known) = self.known.get(&identity) {
            let target = known.map_or(Target::Refused(None), Target::Reached);
            self.name(using.file, target);
            return None;
        }
        match self.files.read(&path) {
            Ok(document) => {
                if let Some(user) = self.open.last_mut() {
                    user.using = Some(using);
                }
                let (document, repeats) = match unroll(&document, self.library) {
                    Some(written_out) => written_out,
                    None => (document, Vec::new()),
                };
                let mut open = Open::new(identity, path.display().to_string(), &document);
                open.document = Some((document, repeats));
                self.open.push(open);
                None
            }
            Err(finding) if finding.code == Code::UNREADABLE_FILE => {
                // Told where the file is named: there is nothing else to look at.
                let file = shortened(&using.file);
                let message = format!("`{file}` cannot be used: {}", finding.message);
                let help = "paths are relative to the folder of this file";
                let finding = Finding::new(finding.code, using.place, message, help);
                self.name(using.file, Target::Refused(Some(finding)));
                self.known.insert(identity, None);
                None
            }
            Err(finding) => {
                if let Some(user) = self.open.last_mut() {
                    user.using = Some(using);
                }
                Some(self.reach(identity, Content::Mistakes(all_mistakes(*finding))))
            }
        }
    }

    /// Why a file must not be used there.
    fn refusal(&self, using: &Use, identity: &Path) -> Option<Finding> {
        let place = using.place.clone();
        if using.file.is_empty() {
            let message = "this names no file, so there is no phenomenon to use";
            let help = "name a graph; paths are relative to the folder of this file";
            return Some(Finding::new(Code::UNREADABLE_FILE, place, message, help));
        }
        if let Some(start) = self.open.iter().position(|open| open.identity == *identity) {
            return Some(self.recursion(start, place));
        }
        if self.open.len() >= MAX_FILE_DEPTH && !self.known.contains_key(identity) {
            let message = format!("phenomena are nested more than {MAX_FILE_DEPTH} files deep");
            let help = "use the inner phenomena side by side, not within one another";
            return Some(Finding::new(Code::RECURSION, place, message, help));
        }
        None
    }

    fn recursion(&self, start: usize, place: Place) -> Finding {
        let files: Vec<String> =
            self.open[start..].iter().map(|open| format!("`{}`", open.name)).collect();
        let message = match files.as_slice() {
            [one] => format!("{one} uses itself"),
            many => format!("phenomena use one another: {} → {}", many.join(" → "), many[0]),
        };
        let help =
            "a phenomenon must not be a part of itself; break the circle at one of its files";
        let mut finding = Finding::new(Code::RECURSION, place, message, help);
        for using in self.open[start..].iter().filter_map(|open| open.using.as_ref()) {
            finding = finding.with_related(using.place.clone(), "uses the next file here");
        }
        finding
    }

    /// Ends the innermost file.
    fn leave(&mut self) -> Option<Reached> {
        let ended = self.open.pop()?;
        let (document, repeats) = ended.document?;
        Some(self.reach(ended.identity, Content::Document(document, repeats, ended.named)))
    }

    /// A file that was reached by the uses that are followed.
    fn reach(&mut self, identity: PathBuf, content: Content) -> Reached {
        let followed = self.open.iter().rev();
        let uses = Uses(followed.filter_map(|open| open.using.clone()).collect());
        self.known.insert(identity, Some(self.count));
        if let Some(using) = self.open.last_mut().and_then(|user| user.using.take()) {
            self.name(using.file, Target::Reached(self.count));
        }
        self.count += 1;
        Reached { content, uses }
    }

    /// Notes what a file is that the innermost one names.
    fn name(&mut self, file: String, target: Target) {
        if let Some(user) = self.open.last_mut() {
            user.named.insert(file, target);
        }
    }
}

/// The files a document names as types of its nodes, each where it does so first, the last one first.
/// What is no phenomenon, or in a format that is not known, names none.
fn uses(document: &Document) -> Vec<Use> {
    let root = &document.root;
    let is_scene = root.get("scene").is_some() && root.get("phenomenon").is_none();
    if is_scene || is_newer_format(root) {
        return Vec::new();
    }
    let mut seen = HashSet::new();
    let mut uses = Vec::new();
    // The phenomena that stand in the file name files as well.
    let mut phenomena = vec![root];
    while let Some(phenomenon) = phenomena.pop() {
        for member in phenomenon.get("nodes").map_or(&[][..], Value::members) {
            let Some(value) = member.value.get("type") else { continue };
            let Some(file) = file_of(value) else { continue };
            if seen.insert(file) {
                let place = document.place(value.get("file").unwrap_or(value));
                uses.push(Use { file: file.to_owned(), place, node: member.key.clone() });
            }
        }
        let inner = phenomenon.get("phenomena").map_or(&[][..], Value::members);
        phenomena.extend(inner.iter().rev().map(|member| &member.value));
    }
    uses.reverse();
    uses
}

/// The file a node's type names, if it names one.
pub(super) fn file_of(value: &Value) -> Option<&str> {
    match &value.get("file")?.kind {
        ValueKind::String(file) => Some(file),
        _ => None,
    }
}
