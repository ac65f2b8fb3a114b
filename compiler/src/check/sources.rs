//! Reading what an input or a root is given: a literal, an interface parameter, a connection.

use crate::diagnostics::synonyms;
use crate::diagnostics::{Advice, Code, Finding, is_near, listed, shortened};
use crate::document::{Reader, Value, ValueKind};
use crate::nodes::Signature;

use super::draft::{Draft, Source, SourceKind};
use super::keys::{COLOR, CONNECTION, CONNECTION_KEYS};
use super::references::{self, Part, quoted};
use super::shape::struct_literal;
use super::type_names::with_article;
use super::{color_literals, components};

const HELP: &str = "write `{ \"node\": \"name\" }`, `{ \"node\": \"name\", \"output\": \"name\" }` or `{ \"interface\": \"name\" }`";

/// Reads a source; the names in it are resolved, types are not looked at.
pub(super) fn read<'d>(reader: &mut Reader<'d>, value: &'d Value, draft: &Draft<'d>) -> Source<'d> {
    let kind = match &value.kind {
        ValueKind::Object(_) if value.get("node").is_some() => {
            let (kind, component) = connection(reader, value, draft);
            return Source { value, kind, component };
        }
        ValueKind::Object(_) if value.get("interface").is_some() => {
            let (kind, component) = parameter(reader, value, draft);
            return Source { value, kind, component };
        }
        ValueKind::Object(_)
            if value.get("texture").is_some()
                || value.get("light").is_some()
                || color_literals::space_of(value).is_some() =>
        {
            SourceKind::Literal
        }
        // It could not be written out as nodes, which was told then.
        ValueKind::Object(_) if value.get("expression").is_some() => SourceKind::Broken,
        ValueKind::Object(_) => {
            no_connection(reader, value);
            SourceKind::Broken
        }
        ValueKind::Null
        | ValueKind::Boolean(_)
        | ValueKind::Number(_)
        | ValueKind::String(_)
        | ValueKind::Array(_) => SourceKind::Literal,
    };
    Source::new(value, kind)
}

/// An object without `node` and `interface`: a misspelt one is one mistake.
fn no_connection(reader: &mut Reader<'_>, value: &Value) {
    if struct_literal(value).is_some() {
        let message = "no struct is taken here";
        reader.report(Code::TYPE_MISMATCH, value, message, "give one value or a connection");
        return;
    }
    let others = ["expression", "texture", "light", "struct"];
    let keys = || CONNECTION_KEYS.into_iter().chain(others);
    let misspelt =
        value.members().iter().find(|member| keys().any(|key| is_near(&member.key, key)));
    let of_color = value
        .members()
        .iter()
        .find(|member| COLOR.keys.iter().any(|key| is_near(&member.key, key.name)));
    match misspelt.or(of_color).or(value.members().first()) {
        Some(member) if misspelt.is_none() && of_color.is_some() => {
            reader.unknown_key(member, COLOR.what, &COLOR.names());
        }
        Some(member) => reader.unknown_key(member, CONNECTION.what, &CONNECTION_KEYS),
        None => reader.report(Code::WRONG_KIND, value, "an empty object connects nothing", HELP),
    }
}

/// A connection to a node, perhaps to a component of an output.
fn connection<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
) -> (SourceKind, Option<char>) {
    let Some(object) = reader.object(value, CONNECTION.what, &CONNECTION_KEYS[..2]) else {
        return (SourceKind::Broken, None);
    };
    let Some(name) = object.optional("node").and_then(|node| reader.string(node, "`node`")) else {
        return (SourceKind::Broken, None);
    };
    let Some(&node) = draft.node_names.get(name) else {
        let lone = object.optional("output").is_none();
        unknown_node(reader, object.optional("node").unwrap_or(value), (name, lone), draft);
        return (SourceKind::Broken, None);
    };
    let Some(node_type) = draft.nodes[node].node_type else {
        return (SourceKind::Node(node, None), None);
    };
    let signature = draft.node_types.signature(node_type);
    let Some(given) = object.optional("output") else {
        return (SourceKind::Node(node, Some(0)), None);
    };
    let Some(output) = reader.string(given, "`output`") else {
        return (SourceKind::Node(node, None), None);
    };
    if let Some(found) = signature.output(output) {
        return (SourceKind::Node(node, Some(found)), None);
    }
    if let Some((found, letter)) = components::of_output(signature, output) {
        return (SourceKind::Node(node, Some(found)), Some(letter));
    }
    unknown_output(reader, draft, given, node, output);
    (SourceKind::Node(node, None), None)
}

/// Reports an output the node does not have.
fn unknown_output(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    given: &Value,
    node: usize,
    output: &str,
) {
    let Some(node_type) = draft.nodes[node].node_type else { return };
    let signature = draft.node_types.signature(node_type);
    let names = || signature.outputs.iter().map(|output| &*output.name);
    let advice = match references::part_of_output(draft, node, output) {
        Some((_, Part::Help(help))) => help.into(),
        Some((of, Part::Component(letter))) => {
            let fix = match output.contains(['.', '/', ':', '[']) {
                true => format!("{}.{letter}", signature.outputs[of].name),
                false => letter.to_string(),
            };
            Advice { help: format!("did you mean `{fix}`?"), fix: Some(quoted(&fix)) }
        }
        None => {
            let has = |name: &str| signature.output(name).is_some();
            match whole_of(signature, output) {
                Some(help) => help.into(),
                None => reader.advice(output, names(), synonyms::output(output, has), || {
                    format!("its outputs are {}", listed(names()))
                }),
            }
        }
    };
    let message = format!("{} has no output `{}`", draft.described(node), shortened(output));
    let place = reader.document.place(given);
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_OUTPUT, place, message, advice));
}

/// What to write instead of a component that the output before the point has not.
fn whole_of(signature: &Signature, text: &str) -> Option<String> {
    let (name, _) = text.rsplit_once('.')?;
    let output = &signature.outputs[signature.output(name)?];
    let has = with_article(output.value_type);
    Some(match components::letters(output.value_type) {
        "" => format!("`{name}` is {has}, which has no components: write `{}`", quoted(name)),
        letters => {
            let forms = letters.chars().map(|letter| format!("{name}.{letter}"));
            let forms: Vec<String> = forms.collect();
            format!(
                "`{name}` is {has}: its components are {}",
                listed(forms.iter().map(String::as_str))
            )
        }
    })
}

/// Reports a connection to a node that does not exist; `lone` is one without `output`.
fn unknown_node(
    reader: &mut Reader<'_>,
    value: &Value,
    (name, lone): (&str, bool),
    draft: &Draft<'_>,
) {
    let advice = match references::meant(draft, name) {
        Some(meant) => Advice { help: meant.help, fix: meant.members.filter(|_| lone) },
        None => {
            // Turns are named by no one.
            let names = draft.nodes.iter().map(|node| match node.member.key.as_str() {
                turn if turn.contains('[') => "",
                name => name,
            });
            reader.advice(name, names, None, || {
                let name = shortened(name);
                format!("add a node `{name}` to `nodes`, or connect another")
            })
        }
    };
    let message = format!("there is no node `{}`", shortened(name));
    let place = reader.document.place(value);
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_NODE, place, message, advice));
}

/// A connection to a parameter, to a part of one, or perhaps to a component of it.
fn parameter<'d>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    draft: &Draft<'d>,
) -> (SourceKind, Option<char>) {
    let Some(object) = reader.object(value, "a connection to the interface", &CONNECTION_KEYS[2..])
    else {
        return (SourceKind::Broken, None);
    };
    let Some(given) = object.optional("interface") else { return (SourceKind::Broken, None) };
    let Some(name) = reader.string(given, "`interface`") else {
        return (SourceKind::Broken, None);
    };
    if let Some(&parameter) = draft.parameter_names.get(name) {
        return (SourceKind::Parameter(parameter), None);
    }
    if let Some(&compound) = draft.compound_names.get(name) {
        return (SourceKind::Compound(compound), None);
    }
    if let Some((parameter, letter)) = components::of_parameter(draft, name) {
        return (SourceKind::Parameter(parameter), Some(letter));
    }
    let whole = name.split(['.', '[']).next().unwrap_or(name);
    if let Some(&parameter) = draft.parameter_names.get(whole)
        && draft.parameters[parameter].value_type.is_none()
    {
        // The declaration made a finding, so its parts are not known.
        return (SourceKind::Parameter(parameter), None);
    }
    unknown_parameter(reader, draft, given, name);
    (SourceKind::Broken, None)
}

/// Reports a connection to a parameter that does not exist, or to a part of one.
fn unknown_parameter(reader: &mut Reader<'_>, draft: &Draft<'_>, given: &Value, name: &str) {
    let whole = name.split(['.', '[']).next().unwrap_or(name);
    let names = || draft.parameters.iter().map(|parameter| parameter.name.as_str());
    let wholes = || draft.compounds.iter().map(|(name, _)| name.as_str());
    // One number is as near as another, so an index is no misspelling.
    let near = match name.contains('[') {
        true => None,
        false => {
            let suggestions = &reader.suggestions;
            suggestions.nearest(name, names()).or_else(|| suggestions.nearest(name, wholes()))
        }
    };
    let part = references::part_of_parameter(draft, name);
    let near = near.filter(|_| part.is_none());
    let advice: Advice = match (part, near) {
        (Some((_, Part::Help(help))), _) => help.into(),
        (Some((of, Part::Component(letter))), _) => {
            let fix = format!("{}.{letter}", draft.parameters[of].name);
            Advice { help: format!("did you mean `{}`?", shortened(&fix)), fix: Some(quoted(&fix)) }
        }
        (None, Some(near)) => near.into(),
        (None, None) if draft.compound_names.contains_key(whole) => {
            let of_whole = |part: &str| {
                part.strip_prefix(whole).is_some_and(|rest| rest.starts_with(['.', '[']))
            };
            let parts = names().filter(|part| of_whole(part));
            format!("its parts are {}", listed(parts)).into()
        }
        _ if draft.node_names.contains_key(name) => {
            format!("for the node write `{{ \"node\": \"{name}\" }}`").into()
        }
        _ if draft.parameters.is_empty() => {
            let name = shortened(name);
            format!(
                "declare it: `\"interface\": {{ \"{name}\": {{ \"type\": …, \"default\": … }} }}`"
            )
            .into()
        }
        _ => format!("its parameters are {}", listed(names())).into(),
    };
    let message = match draft.compound_names.get(whole) {
        Some(&at) if whole != name => format!(
            "parameter `{}` has no part `{}`: it is {}",
            shortened(whole),
            shortened(name.strip_prefix(whole).unwrap_or(name).trim_start_matches('.')),
            draft.compounds[at].1.describe()
        ),
        _ => format!("the interface has no parameter `{}`", shortened(name)),
    };
    let place = reader.document.place(given);
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_PARAMETER, place, message, advice));
}
