//! Type mismatches, with the node that converts.

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::Reader;
use crate::nodes::{DefaultValue, Kind, NodeLibrary, Signature};
use crate::values::Type;

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
    let help = help(draft.node_types.library, from, to, &part);
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
            let name = shortened(&draft.parameters[parameter].name);
            (format!("parameter `{name}`"), name)
        }
        SourceKind::Node(node, Some(output)) => {
            let name = shortened(draft.name(node));
            let output = draft.nodes[node]
                .node_type
                .map_or("", |node_type| draft.node_types.signature(node_type).outputs[output].name);
            (format!("output `{output}` of node `{name}`"), format!("{name}.{output}"))
        }
        _ => ("it".into(), "it".into()),
    }
}

fn help(library: &NodeLibrary, from: Type, to: Type, part: &str) -> String {
    if (from, to) == (Type::Scalar, Type::Integer) {
        return "connect an integer: a scalar is never rounded unasked".into();
    }
    if to.is_uniform() {
        let a = with_article(to);
        return format!("{a} is never computed: give a literal, or a parameter of that type");
    }
    if to == Type::Shader {
        return "connect the output of a node; a parameter would have to be a shader itself".into();
    }
    let single = converters(library, from, to);
    if !single.is_empty() {
        return format!("put `{part}` through {}", single.join(" or "));
    }
    // By way of numbers: take the value apart, put it together anew.
    let apart = converters(library, from, Type::Scalar);
    let together = converters(library, Type::Scalar, to);
    match (apart.first(), together.first()) {
        (Some(apart), Some(together)) => {
            format!("put `{part}` through {apart}, and its outputs through {together}")
        }
        _ => format!("connect {} instead", with_article(to)),
    }
}

/// Up to two nodes of the library (phenomena convert nothing by intent) that make `to` of `from`; those whose parts match in number first.
fn converters(library: &NodeLibrary, from: Type, to: Type) -> Vec<String> {
    let mut found: Vec<(usize, String)> = Vec::new();
    // Those with most outputs first: they keep the most of the value.
    let mut definitions: Vec<_> = library.iter().map(|(_, definition)| definition).collect();
    definitions.sort_by_key(|definition| std::cmp::Reverse(definition.signature.outputs.len()));
    for definition in definitions {
        found.extend(converter(&definition.signature, from, to));
    }
    found.sort_by_key(|(rank, _)| *rank);
    let least = found.first().map_or(0, |(rank, _)| *rank);
    found.into_iter().filter(|(rank, _)| *rank == least).map(|(_, name)| name).take(2).collect()
}

/// How a node makes `to` of `from` if it needs nothing else, and how roundabout that is.
fn converter(signature: &Signature, from: Type, to: Type) -> Option<(usize, String)> {
    if signature.kind != Kind::Plain {
        return None;
    }
    let name = format!("a `{}` node", signature.name);
    let output = signature.outputs.iter().position(|output| output.value_type == to);
    let taken: Vec<bool> = signature.inputs.iter().map(|input| input.value_type == from).collect();
    let needs_more = signature
        .inputs
        .iter()
        .any(|input| matches!(input.default, DefaultValue::Required) && input.value_type != from);
    if needs_more || !taken.contains(&true) {
        return None;
    }
    let all = taken.iter().all(|taken| *taken);
    match output {
        Some(output) if output > 0 => {
            let of = signature.outputs[output].name;
            Some((2, format!("the output `{of}` of {name}")))
        }
        // A node that takes values apart or puts them together is named for just that.
        Some(_)
            if signature.name.starts_with("split_") || signature.name.starts_with("combine_") =>
        {
            Some((0, name))
        }
        Some(_) if all && taken.len() == 1 => Some((0, name)),
        Some(_) if all => Some((3, name)),
        // A choice between two values of the wanted type.
        None if from == Type::Boolean
            && signature.outputs.iter().any(|output| output.value_type == Type::Generic) =>
        {
            Some((1, name))
        }
        _ => None,
    }
}
