//! What a node has, whether its type is one of the library or a phenomenon in a file.

use std::path::Path;

use phenomenon_compiler::check::turns::{ACCUMULATED, Form, INDEX, INITIAL, ITEM, OVER, form_of};
use phenomenon_compiler::document::{Document, Value};
use phenomenon_compiler::nodes::{FINITE, Input, NodeLibrary, Signature};
use phenomenon_compiler::values::Type;

use super::file::OpenFile;
use super::open_files::OpenFiles;
use super::parameters::parameters;
use super::part::{Part, text};
use super::scope::Scope;

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
    scope: &Scope<'_>,
    name: &str,
    written: Option<&str>,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Parts> {
    let known = scope.members("nodes").iter().find(|member| member.key == name);
    match written {
        Some(name) => of_library(name, library),
        None => parts_of_node(scope, &known?.value, library, files),
    }
}

/// What a node has, as it stands in the file.
pub fn parts_of_node(
    scope: &Scope<'_>,
    node: &Value,
    library: &NodeLibrary,
    files: &OpenFiles,
) -> Option<Parts> {
    if let Some(name) = text(node, "type") {
        return of_library(name, library);
    }
    let node_type = node.get("type")?;
    let body = body_of(node_type);
    let named = text(body, "phenomenon").or(text(body, "file"))?;
    let document = phenomenon_of_type(scope, node_type, files)?;
    let mut parts = of_phenomenon(&document, named);
    if let Some((form, _)) = form_of(node_type) {
        to_turns(form, &mut parts);
    }
    Some(parts)
}

/// The body of a map or a fold; any other type is its own.
pub fn body_of(node_type: &Value) -> &Value {
    form_of(node_type).map_or(node_type, |(_, body)| body)
}

/// What a map or a fold has whose body has these parts: of what each turn is given itself the lists.
fn to_turns(form: Form, parts: &mut Parts) {
    parts.title = format!("{} ({})", parts.title, form.name());
    let mut own = Vec::new();
    for (parameter, input) in [(ITEM, OVER), (ACCUMULATED, INITIAL)] {
        let is_given = parameter == ITEM || form == Form::Fold;
        let Some(at) = parts.inputs.iter().position(|part| part.name == parameter) else {
            continue;
        };
        if is_given {
            let part = parts.inputs.remove(at);
            let (of, doc) = match input {
                OVER => (
                    format!("list of {}", part.of),
                    format!("What the turns go over, each as its `{ITEM}`. {}", part.doc),
                ),
                _ => (part.of, format!("What the first turn has as `{ACCUMULATED}`. {}", part.doc)),
            };
            own.push(Part { name: input.into(), of, doc, choices: part.choices });
        }
    }
    parts.inputs.retain(|part| part.name != INDEX);
    own.append(&mut parts.inputs);
    parts.inputs = own;
}

/// What a node of the library has, by its type.
pub fn of_library(name: &str, library: &NodeLibrary) -> Option<Parts> {
    library.find(name).map(|node_type| of_signature(library.signature(node_type)))
}

/// The phenomenon the node called `name` is, in the file as it was JSON last.
pub fn phenomenon_of(scope: &Scope<'_>, name: &str, files: &OpenFiles) -> Option<Document> {
    let node = scope.members("nodes").iter().find(|member| member.key == name)?;
    phenomenon_of_type(scope, node.value.get("type")?, files)
}

/// The phenomenon that is the type of a node: one in another file, or in this one.
fn phenomenon_of_type(scope: &Scope<'_>, of: &Value, files: &OpenFiles) -> Option<Document> {
    let body = body_of(of);
    match text(body, "phenomenon") {
        Some(named) => scope.inner(named),
        None => phenomenon(scope.file, text(body, "file")?, files),
    }
}

/// A phenomenon by the path a file names it with.
pub fn phenomenon(file: &OpenFile, named: &str, files: &OpenFiles) -> Option<Document> {
    files.document(&file.path().parent().unwrap_or(Path::new("")).join(named))
}

fn of_signature(signature: &Signature) -> Parts {
    let of_input = |input: &Input| Part {
        name: input.name.to_string(),
        of: types(signature, input.value_type),
        doc: doc_of(input),
        choices: input.choices.iter().map(|&choice| choice.to_owned()).collect(),
    };
    let outputs = signature.outputs.iter().map(|output| Part {
        name: output.name.to_string(),
        of: types(signature, output.value_type),
        doc: output.doc.clone(),
        choices: Vec::new(),
    });
    Parts {
        title: format!("**{}** ({})", signature.name, signature.group),
        doc: signature.doc.clone(),
        source: signature.source.into(),
        inputs: signature.all_inputs().map(of_input).collect(),
        outputs: outputs.collect(),
    }
}

/// The types an input or an output of a node may have.
fn types(signature: &Signature, value_type: Type) -> String {
    signature.types_of(value_type).iter().map(|of| of.name()).collect::<Vec<_>>().join(" | ")
}

/// What an input means, which values are usual and which it takes, and what they are measured in.
fn doc_of(input: &Input) -> String {
    let mut facts = Vec::new();
    if !input.choices.is_empty() {
        facts.push(format!("One of `{}`", input.choices.join("`, `")));
    } else if input.range != FINITE {
        facts.push(format!("Range: {} to {}", input.range.start(), input.range.end()));
    }
    if let Some(usual) = input.narrower() {
        facts.push(format!("Usually {} to {}", usual.start(), usual.end()));
    }
    if !input.unit.is_empty() {
        facts.push(format!("Unit: {}", input.unit));
    }
    match facts.is_empty() {
        true => input.doc.clone(),
        false => format!("{}\n\n{}", input.doc, facts.join(". ")),
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
