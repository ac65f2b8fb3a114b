//! Type mismatches, with the node that converts.

use crate::diagnostics::{Code, Finding};
use crate::document::{Reader, shortened};
use crate::nodes::{Default, Kind, NodeLibrary, Signature, Type};

use super::draft::{Draft, Source, SourceKind};
use super::literals::with_article;

/// Reports a connection from one type to another that no implicit conversion joins.
pub(super) fn report(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    source: &Source<'_>,
    (from, to): (Type, Type),
    what: &dyn Fn() -> String,
) {
    let (whole, part) = describe(draft, source);
    let message =
        format!("{} takes {}, but {whole} is {}", what(), with_article(to), with_article(from));
    let help = help(draft.library, from, to, &part);
    let mut finding =
        Finding::new(Code::TYPE_MISMATCH, reader.document.place(source.value), message, help);
    if let SourceKind::Parameter(parameter) = source.kind {
        let member = draft.parameters[parameter].member;
        finding = finding.with_related(reader.document.place_of_key(member), "declared here");
    }
    reader.findings.push(finding);
}

/// What the source is, and how it is written in a path.
fn describe(draft: &Draft<'_>, source: &Source<'_>) -> (String, String) {
    match source.kind {
        SourceKind::Parameter(parameter) => {
            let name = shortened(&draft.parameters[parameter].member.key);
            (format!("parameter `{name}`"), name)
        }
        SourceKind::Node(node, Some(output)) => {
            let name = shortened(draft.name(node));
            let output = draft.nodes[node]
                .node_type
                .map_or("", |node_type| draft.library.signature(node_type).outputs[output].name);
            (format!("output `{output}` of node `{name}`"), format!("{name}.{output}"))
        }
        _ => ("it".into(), "it".into()),
    }
}

fn help(library: &NodeLibrary, from: Type, to: Type, part: &str) -> String {
    if (from, to) == (Type::Scalar, Type::Integer) {
        return "connect an integer: a scalar is never rounded unasked".into();
    }
    let converting: Vec<String> = library
        .iter()
        .filter_map(|(_, definition)| converter(&definition.signature, from, to))
        .take(3)
        .collect();
    if converting.is_empty() {
        return format!("connect {} instead", with_article(to));
    }
    format!("put `{part}` through {}", converting.join(" or "))
}

/// How a node makes `to` of `from`, if it needs nothing else.
fn converter(signature: &Signature, from: Type, to: Type) -> Option<String> {
    if signature.kind != Kind::Plain {
        return None;
    }
    let single = match signature.inputs.as_slice() {
        [one] => one,
        inputs => {
            let mut required =
                inputs.iter().filter(|input| matches!(input.default, Default::Required));
            let one = required.next()?;
            if required.next().is_some() {
                return None;
            }
            one
        }
    };
    if single.value_type != from {
        return None;
    }
    let output = signature.outputs.iter().position(|output| output.value_type == to)?;
    Some(match output {
        0 => format!("a `{}` node", signature.name),
        _ => format!(
            "the output `{}` of a `{}` node",
            signature.outputs[output].name, signature.name
        ),
    })
}
