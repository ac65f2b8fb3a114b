//! Values given to the parameters of a graph that was checked: by a scene, or on the command line.
//! They are read as literals in graph files are, by the same reader.

use std::collections::HashSet;

use crate::diagnostics::{Advice, Code, Finding, Place, nearest, shortened};
use crate::document::{Document, Member, Reader, Value, ValueKind, read};
use crate::graph::parts::{Part, Parts};
use crate::graph::{BindError, Graph};
use crate::values::{Literal, Type};

use super::compounds::unknown_member;
use super::files::{Files, OnDisk};
use super::limits::MAX_ADVISED;
use super::literals::{self, Room};
use super::shape::{element_name, member_name, struct_literal};
use super::textures;

/// A value for a parameter, with its place in the file that gives it.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Name of the parameter, or of a part of it.
    pub name: String,
    /// Where the name stands.
    pub key: Place,
    /// Where the value stands.
    pub place: Place,
    /// The file, its root being the value.
    pub document: Document,
}

impl Setting {
    /// The setting that a member of an object is.
    pub fn new(document: &Document, member: &Member) -> Self {
        Self {
            name: member.key.clone(),
            key: document.place_of_key(member),
            place: document.place(&member.value),
            document: Document {
                file: document.file.clone(),
                root: member.value.clone(),
                written: None,
            },
        }
    }

    /// Whether it gives the same value to the same parameter, wherever it stands. Files are named
    /// from the folder of the file, so that has to be the same.
    pub fn is_same(&self, other: &Self) -> bool {
        self.name == other.name
            && self.place.text() == other.place.text()
            && self.document.file.name == other.document.file.name
    }
}

/// Why a value cannot be given to a parameter.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// Text that does not suit the parameter.
    #[error(transparent)]
    Bind(#[from] BindError),
    /// JSON that does not suit it.
    #[error("{}{}", .0.message, if .0.help.is_empty() { String::new() } else { format!("; {}", .0.help) })]
    Json(Box<Finding>),
}

/// The values a setting gives to parameters: one, or those of the parts of an array or a struct. What
/// does not suit is a finding.
pub fn bind_setting(
    graph: &Graph,
    setting: &Setting,
    files: &dyn Files,
) -> (Vec<(String, Literal)>, Vec<Finding>) {
    bind_settings(graph, std::slice::from_ref(setting), files)
}

/// The same of many settings of one graph.
pub fn bind_settings(
    graph: &Graph,
    settings: &[Setting],
    files: &dyn Files,
) -> (Vec<(String, Literal)>, Vec<Finding>) {
    let parts = Parts::of(&graph.parameters);
    let mut values = Vec::new();
    let mut findings = Vec::new();
    let mut given = HashSet::new();
    let mut strangers = 0;
    for setting in settings {
        let before = values.len();
        // Keys that stand twice were told of when the file was read.
        let document = &setting.document;
        let mut reader = Reader::of_part(document);
        match parts.get(&setting.name) {
            Some(_) => {
                let mut spread = Spread { graph, parts: &parts, values: &mut values };
                spread.read(&mut reader, &setting.name, &document.root);
            }
            None => {
                strangers += 1;
                reader.findings.push(unknown(graph, &parts, setting, strangers <= MAX_ADVISED));
            }
        }
        let mut names = values[before..].iter().map(|(name, _)| name);
        if let Some(twice) = names.find(|name| !given.insert((*name).clone())) {
            let message = format!("parameter `{}` is set twice", shortened(twice));
            let help = "leave it out here, or in what is set before";
            reader.findings.push(Finding::new(
                Code::DUPLICATE_KEY,
                setting.key.clone(),
                message,
                help,
            ));
        }
        textures::check(&mut reader, files);
        findings.extend(reader.findings.into_sorted().into_iter().map(|mut finding| {
            // Paths start at the value here, and have to start at the file.
            if finding.place != setting.key {
                let rest = std::mem::take(&mut finding.place.path);
                let stop = if rest.is_empty() || rest.starts_with('[') { "" } else { "." };
                finding.place.path = format!("{}{stop}{rest}", setting.place.path);
            }
            finding
        }));
    }
    (values, findings)
}

/// The values that `text` gives to the parameter `name`, or to its parts: as [`Graph::bind`] takes
/// it, or, where it starts with a bracket, JSON as in a graph file. Files it names are found from the
/// working folder.
///
/// # Errors
/// There is no such parameter, or the text does not suit it.
pub fn bind_text(
    graph: &Graph,
    name: &str,
    text: &str,
) -> Result<Vec<(String, Literal)>, SettingError> {
    let is_string = graph.parameter(name).map(|at| graph.parameters[at].value_type);
    if is_string == Some(Type::String) || !text.trim_start().starts_with(['[', '{']) {
        return Ok(vec![(name.to_owned(), graph.bind(name, text)?)]);
    }
    let document = read("", text.as_bytes()).map_err(SettingError::Json)?;
    if let Some(finding) = Reader::new(&document).findings.into_sorted().into_iter().next() {
        return Err(SettingError::Json(Box::new(finding)));
    }
    let place = document.place(&document.root);
    let setting = Setting { name: name.to_owned(), key: place.clone(), place, document };
    let (values, findings) = bind_setting(graph, &setting, &OnDisk);
    match findings.into_iter().next() {
        Some(finding) => Err(SettingError::Json(Box::new(finding))),
        None => Ok(values),
    }
}

fn unknown(graph: &Graph, parts: &Parts<'_>, setting: &Setting, is_advised: bool) -> Finding {
    let name = &setting.name;
    let message = format!("`{}` has no parameter `{}`", graph.name, shortened(name));
    if !is_advised {
        let help = "so many are unknown that it may be another graph's; leave it out";
        return Finding::new(Code::UNKNOWN_PARAMETER, setting.key.clone(), message, help);
    }
    let help = parts.remedy(name);
    let near = nearest(name, parts.names()).filter(|near| help == near.help());
    let advice = near.map_or_else(|| help.clone().into(), Advice::from);
    Finding::misspelt(Code::UNKNOWN_PARAMETER, setting.key.clone(), message, advice)
}

/// Reads values for a parameter and its parts.
struct Spread<'s, 'g> {
    graph: &'g Graph,
    parts: &'s Parts<'g>,
    values: &'s mut Vec<(String, Literal)>,
}

impl Spread<'_, '_> {
    /// The nesting of documents is bounded, and so is this recursion.
    fn read<'d>(&mut self, reader: &mut Reader<'d>, name: &str, value: &'d Value) {
        let what = || format!("parameter `{}`", shortened(name));
        match self.parts.get(name) {
            None => {}
            Some(Part::One(at)) => {
                if let Some(literal) = self.one(reader, *at, value) {
                    self.values.push((name.to_owned(), literal));
                }
            }
            Some(Part::Array(count)) => {
                let ValueKind::Array(elements) = &value.kind else {
                    let message = format!("{} is an array, not {}", what(), value.describe());
                    let help = format!("write a list of {count}");
                    return reader.report(Code::TYPE_MISMATCH, value, message, help);
                };
                if elements.len() != *count {
                    let given = elements.len();
                    let message = format!("{} has {count} values, but {given} are given", what());
                    let help = "an array has the length its default has; give as many values";
                    return reader.report(Code::WRONG_LENGTH, value, message, help);
                }
                for (at, element) in elements.iter().enumerate() {
                    self.read(reader, &element_name(name, at), element);
                }
            }
            Some(Part::Struct(members)) => {
                let Some(given) = struct_literal(value) else {
                    let message = format!("{} is a struct, not {}", what(), value.describe());
                    let first = members.first().unwrap_or(&"…");
                    let help = format!("write `{{ \"struct\": {{ \"{first}\": … }} }}`");
                    return reader.report(Code::TYPE_MISMATCH, value, message, help);
                };
                reader.object(value, "a struct", &["struct"]);
                for member in reader.members(given, "a struct").into_iter().flatten() {
                    if members.contains(&member.key.as_str()) {
                        self.read(reader, &member_name(name, &member.key), &member.value);
                    } else {
                        unknown_member(reader, member, members);
                    }
                }
            }
        }
    }

    fn one<'d>(&self, reader: &mut Reader<'d>, at: usize, value: &'d Value) -> Option<Literal> {
        let parameter = &self.graph.parameters[at];
        let what = || format!("parameter `{}`", shortened(&parameter.name));
        if let (false, ValueKind::String(_)) = (parameter.labels.is_empty(), &value.kind) {
            let choices: Vec<(&str, i32)> =
                (0..).zip(&parameter.labels).map(|(at, label)| (label.as_str(), at)).collect();
            return reader.choice(value, &what(), &choices).map(Literal::Integer);
        }
        let literal = literals::read(reader, value, parameter.value_type, Room::Literal, &what)?;
        match parameter.admit(literal) {
            Ok(literal) => Some(literal),
            Err(error) => {
                reader.findings.push(misfit(reader.document.place(value), &error));
                None
            }
        }
    }
}

/// What [`Parameter::admit`](crate::graph::Parameter) refuses.
fn misfit(place: Place, error: &BindError) -> Finding {
    let code = match error {
        BindError::Unknown { .. } => Code::UNKNOWN_PARAMETER,
        BindError::Type { .. } => Code::TYPE_MISMATCH,
        BindError::NotFinite { .. } => Code::NOT_FINITE,
        BindError::Range { .. } => Code::NUMBER_OUT_OF_RANGE,
    };
    // The command line has one line for both; a finding has one for each.
    let told = error.to_string();
    let (message, help) = told.rsplit_once("; ").unwrap_or((&told, ""));
    Finding::new(code, place, message, help)
}
