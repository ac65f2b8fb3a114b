//! Type mismatches, with how a value is written or which node converts.

use crate::diagnostics::{Advice, Code, Finding, shortened};
use crate::document::{Reader, Value, ValueKind};
use crate::nodes::{DefaultValue, Input, Kind, NodeLibrary, Signature};
use crate::state::Field;
use crate::values::Type;

use super::color_literals;
use super::draft::{Draft, Source, SourceKind};
use super::expressions::remedy;
use super::shape::Shape;
use super::type_names::{form, with_article};

/// Reports that a place takes one thing and is given another, in three pieces: "input `a` of node
/// `n`", "a color", "not a text".
pub(super) fn report(
    reader: &mut Reader<'_>,
    value: &Value,
    texts: (&str, &str, &str),
    help: impl Into<String>,
) {
    let finding = mismatch(reader, value, texts, help);
    reader.findings.push(finding);
}

fn mismatch(
    reader: &Reader<'_>,
    value: &Value,
    (what, takes, given): (&str, &str, &str),
    help: impl Into<String>,
) -> Finding {
    let message = format!("{what} takes {takes}, {given}");
    Finding::new(Code::TYPE_MISMATCH, reader.document.place(value), message, help)
}

/// Reports a literal that is none of a type; where a connection may stand too, it is told of.
pub(super) fn literal(
    reader: &mut Reader<'_>,
    value: &Value,
    to: Type,
    connects: bool,
    what: &dyn Fn() -> String,
) {
    let (given, remedy) = if value.get("texture").is_some() {
        ("a texture".into(), Some("give it to a `texture_lookup` node, and connect that"))
    } else if value.get("light").is_some() {
        ("a light".into(), Some("give it to the input `lights` of a `light_loop`"))
    } else if color_literals::space_of(value).is_some() {
        (
            "a color".into(),
            Some("give it to a `constant_color` node, and connect what you need of that"),
        )
    } else {
        (value.describe(), None)
    };
    let help = match (remedy, &value.kind) {
        (Some(remedy), _) if connects => remedy.to_owned(),
        (_, ValueKind::String(_)) if to != Type::Shader && connects => format!(
            "{}, or a connection: `{{ \"node\": \"name\" }}` or `{{ \"interface\": \"name\" }}`",
            form(to, connects)
        ),
        _ => form(to, connects).to_owned(),
    };
    report(reader, value, (&what(), &with_article(to), &format!("not {given}")), help);
}

/// Reports a text that is written like a reference, or like a number.
pub(super) fn text(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    value: &Value,
    (what, takes): (&str, &str),
    (advice, parameter): (Advice, Option<usize>),
) {
    let given = format!("not {}", value.describe());
    let mut finding = mismatch(reader, value, (what, takes, &given), advice.help);
    finding.fix = advice.fix;
    reader.findings.push(declared(finding, reader, draft, parameter));
}

/// The same with the declaration of the parameter that is given.
fn declared(
    finding: Finding,
    reader: &Reader<'_>,
    draft: &Draft<'_>,
    parameter: Option<usize>,
) -> Finding {
    match parameter {
        Some(at) => {
            let place = reader.document.place_of_key(draft.parameters[at].member);
            finding.with_related(place, "declared here")
        }
        None => finding,
    }
}

/// Reports a connection from one type to another that no implicit conversion joins.
pub(super) fn connection(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    source: &Source<'_>,
    (from, to): (Type, Type),
    what: &dyn Fn() -> String,
) {
    let (whole, part) = describe(draft, source);
    let given = format!("but {whole} is {}", with_article(from));
    let is_written =
        matches!(source.kind, SourceKind::Node(node, _) if draft.is_written(draft.name(node)));
    let help = match is_written && !to.is_uniform() {
        true => remedy(from, to, &part),
        false => help(draft.node_types.library, from, to, &part),
    };
    let texts = (&*what(), &*with_article(to), &*given);
    let finding = mismatch(reader, source.value, texts, help);
    let parameter = match source.kind {
        SourceKind::Parameter(parameter) => Some(parameter),
        _ => None,
    };
    reader.findings.push(declared(finding, reader, draft, parameter));
}

/// Reports an array or a struct where one value is due.
pub(super) fn compound(
    reader: &mut Reader<'_>,
    value: &Value,
    (name, shape): &(String, Shape),
    to: Type,
    what: &dyn Fn() -> String,
) {
    let takes = with_article(to);
    let given = format!("but parameter `{}` is {}", shortened(name), shape.describe());
    let help = match shape.parts(name).into_iter().find(|(_, of)| of.converts_to(to)) {
        Some((part, _)) => format!("name a part of it, such as `{}`", shortened(&part)),
        None => format!("connect {takes} instead"),
    };
    report(reader, value, (&what(), &takes, &given), help);
}

/// What the source is, and how it is written in a path.
fn describe(draft: &Draft<'_>, source: &Source<'_>) -> (String, String) {
    let (whole, part) = describe_whole(draft, source);
    match source.component {
        None => (whole, part),
        Some(letter) => (format!("component `{letter}` of {whole}"), format!("{part}.{letter}")),
    }
}

fn describe_whole(draft: &Draft<'_>, source: &Source<'_>) -> (String, String) {
    match source.kind {
        SourceKind::Parameter(parameter) => {
            let name = shortened(&draft.parameters[parameter].name);
            (format!("parameter `{name}`"), name)
        }
        SourceKind::Node(node, Some(output)) => {
            if draft.is_written(draft.name(node)) {
                let text = draft.described_output(node, output);
                return (text.clone(), text.trim_matches('`').to_owned());
            }
            let name = draft.told_name(node);
            let output = draft.nodes[node].node_type.map_or("", |node_type| {
                &*draft.node_types.signature(node_type).outputs[output].name
            });
            (format!("output `{output}` of node `{name}`"), format!("{name}.{output}"))
        }
        _ => ("it".into(), "it".into()),
    }
}

fn help(library: &NodeLibrary, from: Type, to: Type, part: &str) -> String {
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
    if from.is_uniform() {
        let a = with_article(from);
        return format!(
            "{a} is known before shading, so nodes neither choose nor compute one: give it to what takes {a}, and choose among the outputs"
        );
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

/// Nodes that are made for changing the type of a value. Others change it too, and are named where none of
/// these does.
const MADE_FOR_IT: [&str; 9] = [
    "color_to_vector",
    "combine_color",
    "combine_vector",
    "length",
    "luminance",
    "select",
    "split_color",
    "split_vector",
    "vector_to_color",
];
/// More than any rank of a node.
const FARTHER: usize = 4;

/// How a node makes `to` of `from` if it needs nothing else, and how roundabout that is.
fn converter(signature: &Signature, from: Type, to: Type) -> Option<(usize, String)> {
    if signature.kind != Kind::Plain {
        return None;
    }
    let name = format!("a `{}` node", signature.name);
    let output = signature.outputs.iter().position(|output| output.value_type == to);
    // What is known before shading says how, and no value arrives there.
    let arriving = signature.inputs.iter().filter(|input| !input.fixed);
    let taken: Vec<bool> = arriving.map(|input| input.value_type == from).collect();
    let needs_more = signature
        .inputs
        .iter()
        .any(|input| matches!(input.default, DefaultValue::Required) && input.value_type != from);
    // What looks at a place makes nothing of it.
    let looks = |input: &Input| matches!(input.default, DefaultValue::State(Field::Point));
    if needs_more || !taken.contains(&true) || signature.inputs.iter().any(looks) {
        return None;
    }
    let all = taken.iter().all(|taken| *taken);
    let made_for_it = MADE_FOR_IT.contains(&&*signature.name);
    let farther = if made_for_it { 0 } else { FARTHER };
    match output {
        Some(output) if output > 0 => {
            let of = &signature.outputs[output].name;
            Some((2 + farther, format!("the output `{of}` of {name}")))
        }
        Some(_) if made_for_it => Some((0, name)),
        Some(_) if all && taken.len() == 1 => Some((farther, name)),
        Some(_) if all => Some((3 + farther, name)),
        // A choice between two values of the wanted type.
        None if from == Type::Boolean
            && signature.outputs.iter().any(|output| output.value_type == Type::Generic)
            && signature.inputs.iter().filter(|it| it.value_type == Type::Generic).count() > 1 =>
        {
            Some((1 + farther, name))
        }
        _ => None,
    }
}
