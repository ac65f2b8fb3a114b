//! What a node has, whether its type is one of the library or a phenomenon in a file.

use std::path::Path;

use phenomenon_compiler::document::{Member, Value, ValueKind};
use phenomenon_compiler::nodes::{FINITE, Input, NodeLibrary, Signature};

use super::file::OpenFile;
use super::open_files::OpenFiles;

/// An input or an output.
#[derive(Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its type.
    pub of: String,
    /// Its doc, with its range.
    pub doc: String,
    /// The names it may be given, where it is a choice.
    pub choices: Vec<String>,
}

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
    of_phenomenon(file, text(known?.value.get("type")?, "file")?, files)
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
pub fn of_phenomenon(file: &OpenFile, named: &str, files: &OpenFiles) -> Option<Parts> {
    let folder = file.path().parent().unwrap_or(Path::new(""));
    let document = files.document(&folder.join(named))?;
    let root = &document.root;
    let of_parameter = |member: &Member| Part {
        name: member.key.clone(),
        of: text(&member.value, "type").unwrap_or_default().into(),
        doc: text(&member.value, "doc").unwrap_or_default().into(),
        choices: Vec::new(),
    };
    let output = |name: &str, of: &str, doc: &str| Part {
        name: name.into(),
        of: of.into(),
        doc: doc.into(),
        choices: Vec::new(),
    };
    Some(Parts {
        title: format!("**{}** ({named})", text(root, "phenomenon").unwrap_or_default()),
        doc: text(root, "doc").unwrap_or_default().into(),
        source: String::new(),
        inputs: root
            .get("interface")
            .map_or(&[][..], Value::members)
            .iter()
            .map(of_parameter)
            .collect(),
        outputs: vec![
            output("color", "color", "The value of its root."),
            output("ok", "boolean", "Whether its root yields a value at all."),
        ],
    })
}

/// The members of a part of the file, as it was JSON last.
pub fn members<'f>(file: &'f OpenFile, part: &str) -> &'f [Member] {
    let part = file.document.as_ref().and_then(|document| document.root.get(part));
    part.map_or(&[], Value::members)
}

/// The string under a key.
pub fn text<'f>(value: &'f Value, key: &str) -> Option<&'f str> {
    match &value.get(key)?.kind {
        ValueKind::String(text) => Some(text),
        _ => None,
    }
}
