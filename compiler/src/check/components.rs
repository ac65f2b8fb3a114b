//! Components of outputs and parameters as connections: `"output": "normal.y"`, `"interface": "tint.r"`.
//! They are written out as the nodes that take values apart, one for each value.

use crate::diagnostics::{Code, Finding, listed};
use crate::document::{Reader, Value};
use crate::graph::Binding;
use crate::nodes::Signature;
use crate::values::Type;

use super::draft::{Draft, Source, SourceKind};
use super::type_names::with_article;
use super::types::Types;

/// The letters of the components of a type, in order; none where it has no components.
pub(super) fn letters(value_type: Type) -> &'static str {
    match value_type {
        Type::Vector => "xyz",
        Type::Color => "rgba",
        // It is of whatever type it is made of.
        Type::Generic => "xyzrgba",
        _ => "",
    }
}

/// The node that takes values of a type apart.
pub(super) fn splitter(value_type: Type) -> &'static str {
    match value_type {
        Type::Vector => "split_vector",
        _ => "split_color",
    }
}

/// The output of a node and its component that a text names: `normal.y`, or `y` where there is one output
/// alone. A name that is an output as a whole is no component.
pub(super) fn of_output(signature: &Signature, text: &str) -> Option<(usize, char)> {
    let (output, letter) = match text.rsplit_once('.') {
        Some((output, letter)) => (signature.output(output)?, letter),
        None if signature.outputs.len() == 1 => (0, text),
        None => return None,
    };
    let letter = single(letter)?;
    letters(signature.outputs[output].value_type).contains(letter).then_some((output, letter))
}

/// The parameter and its component that a text names: `tint.r`.
pub(super) fn of_parameter(draft: &Draft<'_>, text: &str) -> Option<(usize, char)> {
    let (name, letter) = text.rsplit_once('.')?;
    let parameter = *draft.parameter_names.get(name)?;
    let letter = single(letter)?;
    let value_type = draft.parameters[parameter].value_type?;
    letters(value_type).contains(letter).then_some((parameter, letter))
}

fn single(text: &str) -> Option<char> {
    let mut letters = text.chars();
    letters.next().filter(|_| letters.next().is_none())
}

/// The component of a source whose whole is bound so, or none after a finding.
pub(super) fn bind(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    types: &Types,
    source: &Source<'_>,
    whole: Binding,
) -> Option<Binding> {
    let letter = source.component?;
    let value_type = types.of_whole(draft, source)?;
    let Some(output) = letters(value_type).find(letter) else {
        report(reader, source.value, letter, value_type);
        return None;
    };
    let library = draft.node_types.library;
    let Some(node_type) = library.find(splitter(value_type)) else {
        let message =
            format!("the node library lacks `{}`, which a component takes", splitter(value_type));
        let help = "add it to the library";
        reader.report(Code::UNKNOWN_NODE_TYPE, source.value, message, help);
        return None;
    };
    let name = name_of(draft, source);
    let node = draft.splits.borrow_mut().node(library, node_type, name, whole);
    Some(Binding::Node { node, output })
}

/// A name no file can give a node.
fn name_of(draft: &Draft<'_>, source: &Source<'_>) -> String {
    match source.kind {
        SourceKind::Node(node, Some(output)) => {
            let signature = draft.nodes[node].node_type.map(|it| draft.node_types.signature(it));
            let output = signature.map_or("", |signature| &*signature.outputs[output].name);
            format!("{}.{output}.*", draft.name(node))
        }
        SourceKind::Parameter(parameter) => {
            format!("interface.{}.*", draft.parameters[parameter].name)
        }
        _ => "*".into(),
    }
}

/// Reports a letter that the type of the value, known only now, has not.
fn report(reader: &mut Reader<'_>, value: &Value, letter: char, value_type: Type) {
    let text = value.get("output").or(value.get("interface")).unwrap_or(value);
    let message = format!("`{letter}` is no component of {}", with_article(value_type));
    let own = letters(value_type);
    let help = match own {
        "" => "leave the component out: it is one value".into(),
        own => format!("its components are {}", listed(own.split("").filter(|it| !it.is_empty()))),
    };
    // The letter stands before the closing quote.
    let end = text.end.saturating_sub(1).max(text.start);
    let place = reader.document.place_of_bytes(end.saturating_sub(1).max(text.start), end);
    let mut finding = Finding::new(Code::UNKNOWN_OUTPUT, place, message, help);
    let other = ["xyz", "rgb"].iter().find_map(|letters| letters.find(letter));
    finding.fix = other.and_then(|at| own.get(at..=at)).map(str::to_owned);
    reader.findings.push(finding);
}
