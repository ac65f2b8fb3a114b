//! Phenomena inside phenomena: their files, each read and checked once, and recursion.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::{Mutex, OnceLock, PoisonError};

use crate::diagnostics::{Code, Finding, Findings, Place, shortened};
use crate::document::{Document, Reader, Value, all_mistakes};
use crate::nodes::{
    DefaultValue, Definition, FINITE, Input, Kind, NodeLibrary, Output, Overload, Signature,
};
use crate::values::Type;

use super::draft::Draft;
use super::files::Files;
use super::limits::MAX_FILE_DEPTH;
use super::nested::Nested;
use super::phenomenon::check;

/// The files of one run.
pub(super) struct Nest<'n> {
    pub library: &'n NodeLibrary,
    files: &'n dyn Files,
    /// Every file that was read; none where it cannot be used.
    read: HashMap<PathBuf, Option<Rc<Nested>>>,
    /// The files being checked, outermost first, each with its name and the use of the next one.
    stack: Vec<(PathBuf, String, Option<Use>)>,
    findings: Findings,
}

/// Where a file uses another one.
struct Use {
    place: Place,
    /// The node that does.
    node: String,
}

impl<'n> Nest<'n> {
    pub fn new(library: &'n NodeLibrary, files: &'n dyn Files, document: &Document) -> Self {
        let name = document.file.name.clone();
        let stack = vec![(files.identity(Path::new(&name)), name, None)];
        Self { library, files, read: HashMap::new(), stack, findings: Findings::default() }
    }

    /// Where files come from.
    pub fn files(&self) -> &'n dyn Files {
        self.files
    }

    /// What was found in nested files.
    pub fn into_findings(self) -> Vec<Finding> {
        self.findings.into_sorted()
    }

    /// Loads every phenomenon that `nodes` uses and makes node types of them.
    pub fn load<'d>(
        &mut self,
        reader: &mut Reader<'d>,
        nodes: Option<&'d Value>,
        draft: &mut Draft<'d>,
    ) {
        for member in nodes.map_or(&[][..], Value::members) {
            let Some(value) = member.value.get("type") else { continue };
            let Some(file) = file_of(value) else { continue };
            if draft.phenomena.contains_key(file) {
                continue;
            }
            if let Some(object) = reader.object(value, "the type of a node", &["file"]) {
                let place = object.optional("file").unwrap_or(value);
                let found = self.find(reader, file, place, &member.key);
                let node_type = found.and_then(|(path, nested)| {
                    let definition = definition(&path, &nested);
                    let name = definition.signature.name;
                    draft.library.add(definition);
                    let node_type = draft.library.find(name)?;
                    draft.nested.insert(node_type, nested);
                    Some(node_type)
                });
                draft.phenomena.insert(file, node_type);
            }
        }
    }

    /// The phenomenon in a file named in the document of `reader`, and the path of that file.
    fn find(
        &mut self,
        reader: &mut Reader<'_>,
        file: &str,
        value: &Value,
        node: &str,
    ) -> Option<(String, Rc<Nested>)> {
        if file.is_empty() {
            let message = "this names no file, so there is no phenomenon to use";
            let help = "name a graph; paths are relative to the folder of this file";
            reader.report(Code::UNREADABLE_FILE, value, message, help);
            return None;
        }
        let from = Path::new(&reader.document.file.name);
        let path = from.parent().unwrap_or(Path::new("")).join(file);
        let identity = self.files.identity(&path);
        let name = path.display().to_string();
        let place = reader.document.place(value);
        if let Some(start) = self.stack.iter().position(|(open, ..)| *open == identity) {
            reader.findings.push(self.recursion(start, place));
            return None;
        }
        if let Some(read) = self.read.get(&identity) {
            return read.clone().map(|nested| (name, nested));
        }
        if self.stack.len() >= MAX_FILE_DEPTH {
            let message = format!("phenomena are nested more than {MAX_FILE_DEPTH} files deep");
            let help = "use the inner phenomena side by side, not within one another";
            reader.findings.push(Finding::new(Code::RECURSION, place, message, help));
            return None;
        }
        if let Some((.., using)) = self.stack.last_mut() {
            *using = Some(Use { place: place.clone(), node: node.to_owned() });
        }
        let nested = match self.files.read(&path) {
            Ok(document) => {
                self.stack.push((identity.clone(), name.clone(), None));
                let nested = self.check(&document);
                self.stack.pop();
                nested
            }
            Err(finding) if finding.code == Code::UNREADABLE_FILE => {
                // Told where the file is named: there is nothing else to look at.
                let message = format!("`{}` cannot be used: {}", shortened(file), finding.message);
                let help = "paths are relative to the folder of this file";
                reader.findings.push(Finding::new(finding.code, place, message, help));
                None
            }
            Err(finding) => {
                for finding in all_mistakes(*finding) {
                    self.push(finding);
                }
                None
            }
        };
        if let Some((.., using)) = self.stack.last_mut() {
            *using = None;
        }
        self.read.insert(identity, nested.clone());
        nested.map(|nested| (name, nested))
    }

    fn check(&mut self, document: &Document) -> Option<Rc<Nested>> {
        let mut reader = Reader::new(document);
        let checked = check(&mut reader, self);
        let usable = !reader.findings.has_errors();
        for finding in reader.findings.into_sorted() {
            self.push(finding);
        }
        checked.filter(|_| usable).map(Rc::new)
    }

    /// Keeps a finding in a nested file, with the nodes that use the file, innermost first.
    fn push(&mut self, mut finding: Finding) {
        // Their texts cost more than the finding, where there are too many to be shown.
        if !self.findings.is_full() {
            let uses = self.stack.iter().rev().filter_map(|(.., using)| using.as_ref());
            for Use { place, node } in uses {
                // A circle of files shows its uses itself.
                if finding.related.iter().any(|related| related.place == *place) {
                    continue;
                }
                let message = format!("node `{}` uses the file here", shortened(node));
                finding = finding.with_related(place.clone(), message);
            }
        }
        self.findings.push(finding);
    }

    fn recursion(&self, start: usize, place: Place) -> Finding {
        let files: Vec<String> =
            self.stack[start..].iter().map(|(_, name, _)| format!("`{name}`")).collect();
        let message = match files.as_slice() {
            [one] => format!("{one} uses itself"),
            many => format!("phenomena use one another: {} → {}", many.join(" → "), many[0]),
        };
        let help =
            "a phenomenon must not be a part of itself; break the circle at one of its files";
        let mut finding = Finding::new(Code::RECURSION, place, message, help);
        for (.., using) in &self.stack[start..self.stack.len() - 1] {
            if let Some(using) = using {
                finding = finding.with_related(using.place.clone(), "uses the next file here");
            }
        }
        finding
    }
}

/// The file a node's type names, if it names one.
pub(super) fn file_of(value: &Value) -> Option<&str> {
    match &value.get("file")?.kind {
        crate::document::ValueKind::String(file) => Some(file),
        _ => None,
    }
}

/// The node type a phenomenon is: its parameters are the inputs, its root's color and ok the outputs.
fn definition(path: &str, nested: &Nested) -> Definition {
    let inputs: Vec<Input> = nested
        .graph
        .parameters
        .iter()
        .map(|parameter| Input {
            name: interned(&parameter.name),
            doc: parameter.doc.clone(),
            value_type: parameter.value_type,
            default: DefaultValue::Literal(parameter.default.clone()),
            range: parameter.range.clone(),
            avoid: None,
            guarded: false,
            scoped: false,
            list: false,
        })
        .collect();
    let output =
        |name, doc: &str, value_type| Output { name, doc: doc.into(), value_type, range: FINITE };
    let guards = vec![None; inputs.len()];
    Definition {
        signature: Signature {
            name: interned(path),
            group: "phenomena",
            doc: nested.graph.doc.clone(),
            source: "",
            inputs,
            outputs: vec![
                output("color", "The value of its root.", Type::Color),
                output("ok", "Whether its root yields a value at all.", Type::Boolean),
            ],
            kind: Kind::Plain,
        },
        overloads: vec![Overload { generic: None, code: None, guards }],
    }
}

/// A name that lives as long as the program, as signatures want it. Each different name is kept
/// once, so checking the same files again and again costs nothing more.
fn interned(name: &str) -> &'static str {
    static NAMES: OnceLock<Mutex<HashSet<&'static str>>> = OnceLock::new();
    let names = NAMES.get_or_init(Mutex::default);
    let mut names = names.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name) {
        return known;
    }
    let kept: &'static str = Box::leak(name.to_owned().into_boxed_str());
    names.insert(kept);
    kept
}
