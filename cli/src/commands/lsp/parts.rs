//! What a node has, whether its type is one of the library or a phenomenon in a file.

use std::path::Path;

use phenomenon_compiler::document::{Document, Member, Value};
use phenomenon_compiler::nodes::{FINITE, Input, NodeLibrary, Signature};

use super::file::OpenFile;
use super::open_files::OpenFiles;
use super::parameters::parameters;
use super::part::{Part, text};

/// What a node has.
#[derive(Debug)]
pub struct Parts {
    /// The type, with its group or file.
    pub title: String,
    /// What it does, with the formula.
    pub doc: String,
    /// Where it comes from; may be empty.
    pub source: String,
    /// In the order of the signature.
    pub inputs: Vec<Part>,
    /// In the order of the signature.
    pub outputs: Vec<Part>,
}

/// What the node called `name` has. `written` is its type as it stands before the cursor; without
/// it, that of the file as it was JSON last.
pub fn parts_of(
    file: &OpenFile,
    name: &str,
    written: Option<&str>,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Parts> {
    let known = members(file, "nodes").iter().find(|member| member.key == name);
    if let Some(name) = written.or(known.and_then(|member| text(&member.value, "type"))) {
        return library.find(name).map(|node_type| of_signature(library.signature(node_type)));
    }
    of_type(file, known?.value.get("type")?, files)
}

/// What a node has, as it stands in the file.
pub fn parts_of_node(
    file: &OpenFile,
    node: &Value,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Parts> {
    if let Some(name) = text(node, "type") {
        return library.find(name).map(|node_type| of_signature(library.signature(node_type)));
    }
    of_type(file, node.get("type")?, files)
}

/// What a phenomenon has that is the type of a node: one in another file, or in this one.
fn of_type(file: &OpenFile, node_type: &Value, files: &OpenFiles) -> Option<Parts> {
    if let Some(named) = text(node_type, "phenomenon") {
        let document = inner(file.document.as_ref()?, named)?;
        return Some(of_phenomenon(&document, named));
    }
    let named = text(node_type, "file")?;
    phenomenon(file, named, files).map(|document| of_phenomenon(&document, named))
}

/// The phenomenon the node called `name` is, in the file as it was JSON last.
pub fn phenomenon_of(file: &OpenFile, name: &str, files: &OpenFiles) -> Option<Document> {
    let node = members(file, "nodes").iter().find(|member| member.key == name)?;
    let node_type = node.value.get("type")?;
    match text(node_type, "phenomenon") {
        Some(named) => inner(file.document.as_ref()?, named),
        None => phenomenon(file, text(node_type, "file")?, files),
    }
}

/// A phenomenon that stands in the file itself.
fn inner(document: &Document, named: &str) -> Option<Document> {
    let root = document.root.get("phenomena")?.get(named)?.clone();
    Some(Document { file: document.file.clone(), root })
}

/// A phenomenon by the path a file names it with.
pub fn phenomenon(file: &OpenFile, named: &str, files: &OpenFiles) -> Option<Document> {
    files.document(&file.path().parent().unwrap_or(Path::new("")).join(named))
}

fn of_signature(signature: &Signature) -> Parts {
    let of_input = |input: &Input| Part {
        name: input.name.to_string(),
        of: input.value_type.name().into(),
        doc: if !input.choices.is_empty() {
            format!("{}\n\nOne of `{}`", input.doc, input.choices.join("`, `"))
        } else if input.range == FINITE {
            input.doc.clone()
        } else {
            format!("{}\n\nRange: {} to {}", input.doc, input.range.start(), input.range.end())
        },
        choices: input.choices.iter().map(|&choice| choice.to_owned()).collect(),
    };
    let outputs = signature.outputs.iter().map(|output| Part {
        name: output.name.to_string(),
        of: output.value_type.name().into(),
        doc: output.doc.clone(),
        choices: Vec::new(),
    });
    Parts {
        title: format!("**{}** ({})", signature.name, signature.group),
        doc: signature.doc.clone(),
        source: signature.source.into(),
        inputs: signature.inputs.iter().map(of_input).collect(),
        outputs: outputs.collect(),
    }
}

/// The parts of a phenomenon, as far as its file is understood: it may be in the making, too.
fn of_phenomenon(document: &Document, named: &str) -> Parts {
    let root = &document.root;
    Parts {
        title: format!("**{}** ({named})", text(root, "phenomenon").unwrap_or(named)),
        doc: text(root, "doc").unwrap_or_default().into(),
        source: String::new(),
        inputs: parameters(document),
        outputs: outputs_of(root),
    }
}

/// What a phenomenon offers: the value of its root, and what it declares.
fn outputs_of(root: &Value) -> Vec<Part> {
    let output = |name: &str, of: &str, doc: &str| Part {
        name: name.into(),
        of: of.into(),
        doc: doc.into(),
        choices: Vec::new(),
    };
    let mut outputs = match (root.get("roots"), root.get("outputs")) {
        (None, Some(_)) => Vec::new(),
        _ => vec![
            output("color", "color", "The value of its root."),
            output("ok", "boolean", "Whether its root yields a value at all."),
        ],
    };
    for member in root.get("outputs").map_or(&[][..], Value::members) {
        let of = text(&member.value, "type").unwrap_or_default();
        let declared = output(&member.key, of, text(&member.value, "doc").unwrap_or_default());
        match outputs.iter_mut().find(|known| known.name == member.key) {
            Some(known) => *known = declared,
            None => outputs.push(declared),
        }
    }
    outputs
}

/// The members of a part of the file, as it was JSON last.
pub fn members<'f>(file: &'f OpenFile, part: &str) -> &'f [Member] {
    let part = file.document.as_ref().and_then(|document| document.root.get(part));
    part.map_or(&[], Value::members)
}
