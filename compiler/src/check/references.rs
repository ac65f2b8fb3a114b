//! References in another form than ours: `"tint"`, `"shade.result"`, `"point.y"`. They are never
//! followed, but it can be said how they are written here.

use crate::diagnostics::synonyms;
use crate::diagnostics::{Advice, shortened};
use crate::document::{Reader, Value, ValueKind};
use crate::values::Type;

use super::draft::Draft;
use super::turns::written_name;
use super::type_names::with_article;
use super::{components, mismatch};

/// Longest text that is taken for a reference.
const LONGEST: usize = 512;

/// What a reference in another form means.
pub(super) struct Meant {
    /// How to write it.
    pub help: String,
    /// The members of the connection, where the text names just that.
    pub members: Option<String>,
    /// The type of what it names, where that is known.
    value_type: Option<Type>,
    /// The parameter it names.
    parameter: Option<usize>,
}

/// What a text names, as far as it names something of the graph.
pub(super) fn meant(draft: &Draft<'_>, text: &str) -> Option<Meant> {
    if text.len() > LONGEST {
        return None;
    }
    let bare = text.trim().trim_start_matches(['$', '@', '#', '&', '%', '{', '<', '.', '/']);
    let bare = bare.trim_end_matches(['}', '>']);
    let (mut nodes, mut parameters) = (true, true);
    let mut path = bare;
    let of_nodes = ["nodes.", "node.", "nodes/", "node:"];
    let of_parameters = ["interface.", "parameters.", "params.", "interface/", "interface:"];
    if let Some(rest) = of_nodes.iter().find_map(|prefix| bare.strip_prefix(prefix)) {
        (path, parameters) = (rest, false);
    } else if let Some(rest) = of_parameters.iter().find_map(|prefix| bare.strip_prefix(prefix)) {
        (path, nodes) = (rest, false);
    }
    let is_parameter = |name: &str| {
        parameters
            && (draft.parameter_names.contains_key(name) || draft.compound_names.contains_key(name))
    };
    match (nodes && draft.node_names.contains_key(path), is_parameter(path)) {
        (true, true) => {
            let name = shortened(path);
            let help = format!(
                "write `{{ \"node\": \"{name}\" }}` for the node, `{{ \"interface\": \"{name}\" }}` for the parameter"
            );
            return Some(Meant { help, members: None, value_type: None, parameter: None });
        }
        (true, false) => return Some(node(draft, path, None)),
        (false, true) => return Some(parameter(draft, path)),
        (false, false) => {}
    }
    // `shade.result`, `shade/result`, `shade:result`, `shade->result`
    for (at, separator) in path.match_indices(['.', '/', ':', '>', '|', '#']) {
        let head = path[..at].trim_end_matches('-');
        let tail = &path[at + separator.len()..];
        if nodes && draft.node_names.contains_key(head) {
            return Some(node(draft, head, Some(tail)));
        }
        if is_parameter(head) {
            return match part_of_parameter(draft, &format!("{head}.{tail}"))? {
                (_, Part::Help(help)) => {
                    Some(Meant { help, members: None, value_type: None, parameter: None })
                }
                (at, Part::Component(letter)) => Some(component(
                    format!("\"interface\": {}", quoted(&format!("{head}.{letter}"))),
                    Some(at),
                )),
            };
        }
    }
    None
}

fn parameter(draft: &Draft<'_>, name: &str) -> Meant {
    let members = format!("\"interface\": {}", quoted(name));
    let position = draft.parameter_names.get(name).copied();
    Meant {
        help: format!(
            "`{0}` is a parameter: write `{{ \"interface\": \"{0}\" }}`",
            shortened(name)
        ),
        members: Some(members),
        value_type: position.and_then(|at| draft.parameters[at].value_type),
        parameter: position,
    }
}

/// A component of an output or a parameter, as the members of the connection to it.
fn component(members: String, parameter: Option<usize>) -> Meant {
    let help = format!("write `{{ {} }}`", shortened(&members));
    Meant { help, members: Some(members), value_type: Some(Type::Scalar), parameter }
}

/// What `name`, or `name.rest`, means of a node that exists.
fn node(draft: &Draft<'_>, name: &str, rest: Option<&str>) -> Meant {
    let at = draft.node_names[name];
    let signature = draft.nodes[at].node_type.map(|it| draft.node_types.signature(it));
    let shown = shortened(name);
    let unsure = |help: String| Meant { help, members: None, value_type: None, parameter: None };
    let written = |output: &str| {
        format!("`{{ \"node\": \"{shown}\", \"output\": \"{}\" }}`", shortened(output))
    };
    let Some(rest) = rest else {
        let value_type = signature.and_then(|it| it.outputs.first()).map(|it| it.value_type);
        let help = format!("`{shown}` is a node: write `{{ \"node\": \"{shown}\" }}`");
        let members = Some(format!("\"node\": {}", quoted(name)));
        return Meant { help, members, value_type, parameter: None };
    };
    let Some(signature) = signature else {
        return unsure(format!("write {}", written(rest)));
    };
    let has = |output: &str| signature.output(output).is_some();
    if let Some(output) = signature.output(rest) {
        return Meant {
            help: format!("write {}", written(rest)),
            members: Some(format!("\"node\": {}, \"output\": {}", quoted(name), quoted(rest))),
            value_type: Some(signature.outputs[output].value_type),
            parameter: None,
        };
    }
    match part_of_output(draft, at, rest) {
        Some((_, Part::Help(help))) => return unsure(help),
        Some((output, Part::Component(letter))) => {
            let output = quoted(&format!("{}.{letter}", signature.outputs[output].name));
            let node = quoted(name);
            return component(format!("\"node\": {node}, \"output\": {output}"), None);
        }
        None => {}
    }
    if let Some(found) = synonyms::output(rest, has) {
        let output = found.ours.first().copied().unwrap_or(rest);
        return unsure(format!("write {}", written(output)));
    }
    let outputs = signature.outputs.iter().map(|output| &*output.name);
    let outputs = crate::diagnostics::listed(outputs);
    unsure(format!("write `{{ \"node\": \"{shown}\", \"output\": … }}`; its outputs are {outputs}"))
}

/// What takes a part of a value.
pub(super) enum Part {
    /// One of its components, by the letter it has here.
    Component(char),
    /// What to do for several of them.
    Help(String),
}

/// How to take a part of an output of a node: of `point.y`, or of `y` where a vector is the only output.
pub(super) fn part_of_output(draft: &Draft<'_>, node: usize, text: &str) -> Option<(usize, Part)> {
    let signature = draft.node_types.signature(draft.nodes[node].node_type?);
    let name = draft.told_name(node);
    let split = text.split_once(['.', '/', ':', '[']);
    let (at, part) = match split {
        Some((output, part)) => (signature.output(output)?, part.trim_end_matches(']')),
        None if signature.outputs.len() == 1 => (0, text),
        None => return None,
    };
    let output = &signature.outputs[at];
    let value = match signature.outputs.len() {
        1 => name,
        _ => format!("{name}.{}", output.name),
    };
    Some((at, part_of(output.value_type, part, &value)?))
}

/// The same of a parameter: of `tint.r`.
pub(super) fn part_of_parameter(draft: &Draft<'_>, text: &str) -> Option<(usize, Part)> {
    let (name, part) = text.rsplit_once(['.', '/', ':'])?;
    let parameter = *draft.parameter_names.get(name)?;
    let value_type = draft.parameters[parameter].value_type?;
    Some((parameter, part_of(value_type, part, &shortened(name))?))
}

/// How to take the part of a value.
fn part_of(value_type: Type, part: &str, value: &str) -> Option<Part> {
    let letters: Vec<char> = part.to_lowercase().chars().collect();
    if letters.len() > 4 {
        return None;
    }
    let (spatial, colored) = (components::letters(Type::Vector), components::letters(Type::Color));
    let is_spatial = !letters.is_empty() && letters.iter().all(|&c| spatial.contains(c));
    // A generic value has the type of what it is made of, which is not known here.
    let (split, combine, own) = match value_type {
        Type::Vector => ("split_vector", "combine_vector", spatial),
        Type::Color => ("split_color", "combine_color", colored),
        Type::Generic if is_spatial => ("split_vector", "combine_vector", spatial),
        Type::Generic => ("split_color", "combine_color", colored),
        _ => return None,
    };
    // The other alphabet, and numbers, count along.
    let letter = |c: &char| {
        let at = match c {
            'x' | 'r' | '0' => 0,
            'y' | 'g' | '1' => 1,
            'z' | 'b' | '2' => 2,
            'w' | 'a' | '3' => 3,
            _ => return None,
        };
        own.chars().nth(at)
    };
    let letters: Option<String> = letters.iter().map(letter).collect();
    let letters = letters?;
    let mut each = letters.chars();
    match (each.next(), each.next()) {
        (None, _) => None,
        (Some(one), None) => Some(Part::Component(one)),
        _ if own.starts_with(&letters) && letters.len() >= 3 => {
            Some(Part::Help(format!("connect `{value}` as a whole")))
        }
        _ => Some(Part::Help(format!(
            "put `{value}` through a `{split}` node, and its outputs through a `{combine}` node"
        ))),
    }
}

/// Reports a string that stands where a value is due and names something of the graph, or holds a number;
/// false, and nothing said, for any other value. `to` is none where words are values.
pub(super) fn report(
    reader: &mut Reader<'_>,
    draft: &Draft<'_>,
    value: &Value,
    to: Option<Type>,
    what: &dyn Fn() -> String,
) -> bool {
    let ValueKind::String(text) = &value.kind else { return false };
    if to == Some(Type::String) {
        return false;
    }
    let Some((help, fix, parameter)) = remedy(reader, draft, text, to) else { return false };
    let takes = to.map_or_else(|| "one of its words".to_owned(), with_article);
    mismatch::text(reader, draft, value, (&what(), &takes), (Advice { help, fix }, parameter));
    true
}

/// The help, what surely mends it, and the parameter that is meant.
fn remedy(
    reader: &Reader<'_>,
    draft: &Draft<'_>,
    text: &str,
    to: Option<Type>,
) -> Option<(String, Option<String>, Option<usize>)> {
    if let Some(meant) = meant(draft, text) {
        let suits = to.zip(meant.value_type).is_some_and(|(to, from)| from.converts_to(to))
            || meant.value_type == Some(Type::Generic) && to.is_some_and(Type::is_numeric);
        // A generic input takes what any of its forms takes.
        let generic = to == Some(Type::Generic)
            && meant.value_type.is_some_and(|from| {
                [Type::Scalar, Type::Vector, Type::Color].into_iter().any(|to| from.converts_to(to))
            });
        let fix = meant.members.filter(|_| suits || generic);
        return Some((meant.help, fix.map(|members| format!("{{ {members} }}")), meant.parameter));
    }
    let bare = text.trim();
    let is_number = serde_json::from_str::<f64>(bare).is_ok();
    let fitting = match to? {
        Type::Boolean => matches!(bare, "true" | "false"),
        Type::Integer | Type::Scalar | Type::Color | Type::Generic => is_number,
        _ => false,
    };
    if fitting {
        return Some((format!("write it without quotes: `{bare}`"), Some(bare.to_owned()), None));
    }
    // The name of a node or a parameter, misspelt.
    let names = draft.nodes.iter().map(|node| written_name(&node.member.key));
    let node = reader.suggestions.nearest(bare, names);
    let names = draft.parameters.iter().map(|parameter| parameter.name.as_str());
    let parameter = reader.suggestions.nearest(bare, names);
    let form = match (node, parameter) {
        (Some(node), None) => format!("\"node\": \"{}\"", shortened(node.name)),
        (None, Some(parameter)) => format!("\"interface\": \"{}\"", shortened(parameter.name)),
        _ => return None,
    };
    Some((format!("did you mean the connection `{{ {form} }}`?"), None, None))
}

/// A name as it is written in JSON.
pub(super) fn quoted(name: &str) -> String {
    serde_json::Value::from(name).to_string()
}
