//! Whether a scene and the graphs it uses fit: the roots that are called, the parameters that are
//! set, the lights that are asked for. `check` reports what does not, and `render` refuses it.

use std::collections::HashSet;

use phenomenon_compiler::check::{Files, Setting, bind_settings};
use phenomenon_compiler::diagnostics::{Advice, Code, Finding, Place, listed, nearest};
use phenomenon_compiler::document::{Document, Value, ValueKind};
use phenomenon_compiler::graph::{Binding, Graph};
use phenomenon_compiler::values::Literal;

use super::description::{GraphUse, MaterialRef, PresetRef};
use super::file::LightNames;

/// The root that a use of a graph calls, and the graph lacks.
pub fn missing_root(used: &GraphUse, graph: &Graph) -> Option<Finding> {
    let root = used.root.name();
    if graph.root(used.root).is_some() {
        return None;
    }
    let message = format!("`{}` has no `{root}` root", graph.name);
    let help = format!("give it one, or use a graph here that has the root `{root}`");
    Some(Finding::new(Code::MISSING_ROOT, used.material.place.clone(), message, help))
}

/// The values a scene gives to the parameters of a graph, by a preset too; those that do not suit are findings, and so
/// are pictures among them that cannot be used.
pub fn settings(
    material: &MaterialRef,
    graph: &Graph,
    files: &dyn Files,
) -> (Vec<(String, Literal)>, Vec<Finding>) {
    let (set, mut findings) = bind_settings(graph, &material.set, files);
    let Some(PresetRef { name, place }) = &material.preset else { return (set, findings) };
    match graph.preset(name) {
        Ok(preset) => (preset.with(set), findings),
        Err(error) => {
            let (code, message) = (Code::UNKNOWN_PRESET, error.to_string());
            findings.push(Finding::misspelt(code, place.clone(), message, error.advice));
            (set, findings)
        }
    }
}

/// The names of lights a graph asks for and the scene does not have: they would light nothing,
/// unsaid. `values` are those given for its parameters, by the scene or otherwise; `document` is the
/// file of the graph, in which its own names have their places.
pub fn unknown_lights(
    lights: &LightNames,
    material: &MaterialRef,
    graph: &Graph,
    values: &[(String, Literal)],
    document: Option<&Document>,
) -> Vec<Finding> {
    let names: HashSet<&str> = values.iter().map(|(name, _)| name.as_str()).collect();
    let is_given = |parameter: &str| names.contains(parameter);
    let inputs = graph.nodes.iter().flat_map(|node| &node.inputs);
    let literals = inputs.filter_map(|binding| match binding {
        Binding::Literal(literal) => Some(literal),
        _ => None,
    });
    // A setting that was refused may have been meant for any parameter: defaults say nothing then.
    let sure = material.set.iter().all(|set| names.iter().any(|name| gives(set, name)));
    let defaults = graph.parameters.iter().filter(|parameter| sure && !is_given(&parameter.name));
    let own = unknown(lights, literals.chain(defaults.map(|parameter| &parameter.default)));
    let mut findings: Vec<Finding> = own
        .into_iter()
        .map(|name| {
            let place = document.and_then(|document| {
                place_in_graph(document, &document.root, name, &is_given)
                    .map(|value| document.place(value))
            });
            finding(lights, material, graph, name, place)
        })
        .collect();
    for (parameter, literal) in values {
        if findings.len() >= MAX_UNKNOWN_LIGHTS {
            break;
        }
        let set = material.set.iter().find(|set| gives(set, parameter));
        for name in unknown(lights, std::iter::once(literal)) {
            let place = set.map(|set| place_in_setting(set, name));
            findings.push(finding(lights, material, graph, name, place));
        }
    }
    findings
}

/// Most lights a scene has not that are told of one graph: beyond, it was made for another scene.
pub const MAX_UNKNOWN_LIGHTS: usize = 64;

/// Names among `literals` that are no light's, each once, the first ones.
fn unknown<'g>(
    lights: &LightNames,
    literals: impl Iterator<Item = &'g Literal>,
) -> Vec<&'g String> {
    let mut unknown = Vec::new();
    for literal in literals {
        let names = match literal {
            Literal::Lights(names) => names.as_slice(),
            Literal::Light(name) => std::slice::from_ref(name),
            _ => continue,
        };
        for name in names {
            if unknown.len() == MAX_UNKNOWN_LIGHTS {
                return unknown;
            }
            if !lights.names.contains(name) && !unknown.contains(&name) {
                unknown.push(name);
            }
        }
    }
    unknown
}

/// Where a graph says `{ "light": name }`, but for parameters that are given. The nesting of
/// documents is bounded, and so is this recursion.
fn place_in_graph<'d>(
    document: &Document,
    value: &'d Value,
    name: &str,
    is_given: &impl Fn(&str) -> bool,
) -> Option<&'d Value> {
    match &value.kind {
        ValueKind::Array(elements) => {
            elements.iter().find_map(|element| place_in_graph(document, element, name, is_given))
        }
        ValueKind::Object(members) => members.iter().find_map(|member| match &member.value.kind {
            ValueKind::String(text) if member.key == "light" && text == name => Some(&member.value),
            _ if is_given(&member.key) && is_parameter(document, value) => None,
            _ => place_in_graph(document, &member.value, name, is_given),
        }),
        _ => None,
    }
}

/// Whether a setting gives a parameter its value, alone or as a part of an array or a struct.
fn gives(setting: &Setting, parameter: &str) -> bool {
    let rest = parameter.strip_prefix(setting.name.as_str());
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// Where a setting says `{ "light": name }`.
fn place_in_setting(setting: &Setting, name: &str) -> Place {
    let document = &setting.document;
    let value = place_in_graph(document, &document.root, name, &|_| false);
    value.map_or(setting.place.clone(), |value| Place {
        start: value.start,
        end: value.end,
        ..setting.place.clone()
    })
}

/// Whether `value` is the object of the parameters.
fn is_parameter(document: &Document, value: &Value) -> bool {
    document.root.get("interface").is_some_and(|interface| std::ptr::eq(interface, value))
}

fn finding(
    lights: &LightNames,
    material: &MaterialRef,
    graph: &Graph,
    name: &str,
    place: Option<Place>,
) -> Finding {
    let names = || lights.names.iter().map(String::as_str);
    let mut advice = Advice::of(None, nearest(name, names()), || match lights.names.is_empty() {
        true => "it has no lights at all; add one to `lights`".to_owned(),
        false => format!("its lights are {}", listed(names())),
    });
    let graph = &graph.name;
    let message = format!("`{graph}` names the light `{name}`, which the scene does not have");
    let own = place.as_ref().is_some_and(|place| place.file == material.place.file);
    let elsewhere = place.is_some() && !own;
    let place = place.unwrap_or_else(|| material.place.clone());
    // The text of a place is a name only where it is a string: a list of names is none.
    let is_name = place.text().starts_with('"');
    if !own || !is_name {
        advice.fix = None;
    }
    let mut finding = Finding::misspelt(Code::UNKNOWN_LIGHT, place, message, advice);
    if elsewhere {
        finding = finding.with_related(material.place.clone(), "the scene uses it here");
    }
    match &lights.place {
        Some(place) => finding.with_related(place.clone(), "the lights of the scene"),
        None => finding,
    }
}
