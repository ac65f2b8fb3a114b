//! Whether a scene and the graphs it uses fit: the roots that are called, the parameters that are
//! set, the lights that are asked for. `check` reports what does not, and `render` refuses it.

use std::path::Path;

use phenomenon_compiler::check::{Files, OnDisk};
use phenomenon_compiler::diagnostics::{Code, Finding, Place};
use phenomenon_compiler::document::{Document, Value, ValueKind, nearest};
use phenomenon_compiler::graph::{BindError, Binding, Graph};
use phenomenon_compiler::nodes::Literal;

use super::description::{GraphUse, MaterialRef, Override};
use super::file::LightNames;

/// What does not fit between a use of a graph and the graph: its roots and its parameters.
pub fn misfits(used: &GraphUse, graph: &Graph) -> Vec<Finding> {
    let (_, mut findings) = settings(&used.material, graph);
    let root = used.root.name();
    if graph.root(used.root).is_none() {
        let message = format!("`{}` has no `{root}` root", graph.name);
        let help = format!("give it one, or use a graph here that has the root `{root}`");
        let place = used.material.place.clone();
        findings.push(Finding::new(Code::MISSING_ROOT, place, message, help));
    }
    findings
}

/// The values a scene gives to the parameters of a graph; those that do not suit are findings.
pub fn settings(material: &MaterialRef, graph: &Graph) -> (Vec<(String, Literal)>, Vec<Finding>) {
    let mut values = Vec::with_capacity(material.set.len());
    let mut findings = Vec::new();
    for set in &material.set {
        match graph.bind(&set.name, &set.text) {
            Ok(literal) => {
                findings.extend(missing_texture(set, &literal));
                values.push((set.name.clone(), literal));
            }
            Err(error) => findings.push(misfit(set, graph, &error)),
        }
    }
    (values, findings)
}

/// A texture that is not there.
fn missing_texture(set: &Override, literal: &Literal) -> Option<Finding> {
    let Literal::Texture(Some(texture)) = literal else { return None };
    let why = OnDisk.unusable(Path::new(&texture.file))?;
    let message = format!("the texture `{}` cannot be used: {why}", texture.file);
    let help = "paths are relative to the folder of this file";
    Some(Finding::new(Code::UNREADABLE_FILE, set.place.clone(), message, help))
}

fn misfit(set: &Override, graph: &Graph, error: &BindError) -> Finding {
    let (code, place) = match error {
        BindError::Unknown { .. } => (Code::UNKNOWN_PARAMETER, &set.key),
        BindError::Type { .. } => (Code::TYPE_MISMATCH, &set.place),
        BindError::NotFinite { .. } => (Code::NOT_FINITE, &set.place),
        BindError::Range { .. } => (Code::NUMBER_OUT_OF_RANGE, &set.place),
    };
    // The command line has one line for both; a finding has one for each.
    let told = error.to_string();
    let (message, help) = told.rsplit_once("; ").unwrap_or((&told, ""));
    let mut finding = Finding::new(code, place.clone(), message, help);
    if code == Code::UNKNOWN_PARAMETER {
        let names = graph.parameters.iter().map(|parameter| parameter.name.as_str());
        finding.fix = nearest(&set.name, names).and_then(|near| near.fix());
    }
    finding
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
    let is_given = |parameter: &str| values.iter().any(|(name, _)| name == parameter);
    let inputs = graph.nodes.iter().flat_map(|node| &node.inputs);
    let literals = inputs.filter_map(|binding| match binding {
        Binding::Literal(literal) => Some(literal),
        _ => None,
    });
    // A setting that was refused may have been meant for any parameter: defaults say nothing then.
    let sure = material.set.iter().all(|set| is_given(&set.name));
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
        let set = material.set.iter().find(|set| set.name == *parameter);
        for name in unknown(lights, std::iter::once(literal)) {
            let part = set.and_then(|set| set.parts.iter().find(|(text, _)| text == name));
            let place = part.map(|(_, place)| place).or(set.map(|set| &set.place));
            findings.push(finding(lights, material, graph, name, place.cloned()));
        }
    }
    findings
}

/// Names among `literals` that are no light's, each once.
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
    let near = nearest(name, lights.names.iter().map(String::as_str));
    let help = match (&near, lights.names.as_slice()) {
        (Some(near), _) => near.help(),
        (None, []) => "it has no lights at all; add one to `lights`".to_owned(),
        (None, names) => format!("its lights are `{}`", names.join("`, `")),
    };
    let graph = &graph.name;
    let message = format!("`{graph}` asks for the light `{name}`, which the scene does not have");
    let own = place.as_ref().is_some_and(|place| place.file == material.place.file);
    let elsewhere = place.is_some() && !own;
    let place = place.unwrap_or_else(|| material.place.clone());
    // The text of a place is a name only where it is a string: a list of names is none.
    let is_name = place.text().starts_with('"');
    let mut finding = Finding::new(Code::UNKNOWN_LIGHT, place, message, help);
    if own && is_name {
        finding.fix = near.and_then(|near| near.fix());
    }
    if elsewhere {
        finding = finding.with_related(material.place.clone(), "the scene uses it here");
    }
    match &lights.place {
        Some(place) => finding.with_related(place.clone(), "the lights of the scene"),
        None => finding,
    }
}
