//! What a phenomenon requires of the renderer: mental ray's requirements, joined over the file,
//! its nodes and the phenomena it uses.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostics::{Code, Finding, Place, shortened};
use crate::document::{Key, Kind, Member, Reader, Value};
use crate::effects::{Asked, Effect, Trace};
use crate::nodes;

use super::draft::Draft;
use super::keys;
use crate::graph::{Requirements, RootKind};

/// Requirements as far as they are joined, with who has those that two parts of a scene cannot have
/// differently.
#[derive(Clone, Debug, Default)]
pub(super) struct Joined {
    exclusive: BTreeMap<&'static str, Required>,
    /// Keys of which a conflict was told: those who require either make no new mistake.
    conflicts: BTreeSet<&'static str>,
    /// All but the exclusive ones.
    rest: Requirements,
}

/// One requirement.
#[derive(Clone, Debug)]
struct Required {
    value: &'static str,
    /// Who requires it, for messages.
    by: String,
    place: Place,
}

impl Joined {
    /// What is required in the end.
    pub fn finish(&self) -> Requirements {
        let choices = self.exclusive.iter().map(|(key, required)| (*key, required.value));
        Requirements { choices: choices.collect(), ..self.rest.clone() }
    }

    /// Joins what a nested phenomenon requires, all but what it may be used as, which is its own.
    fn join_nested(&mut self, nested: &Requirements) {
        self.rest.texture = self.rest.texture.max(nested.texture);
        self.rest.bump = self.rest.bump.max(nested.bump);
        self.rest.volume_level = self.rest.volume_level.max(nested.volume_level);
        self.rest.derivative.extend(&nested.derivative);
        // All must allow it.
        self.rest.parallel = match (self.rest.parallel, nested.parallel) {
            (Some(a), Some(b)) => Some(a && b),
            (one, other) => one.or(other),
        };
    }

    /// Adds a requirement; where it contradicts one that is there, the finding names both.
    fn join(&mut self, reader: &mut Reader<'_>, key: &'static str, required: Required) {
        let Some(there) = self.exclusive.get_mut(key) else {
            self.exclusive.insert(key, required);
            return;
        };
        if there.value == required.value {
            return;
        }
        // Any shadows at all are also sorted ones, or segments.
        let refines = |general: &str, special: &str| {
            key == "shadow" && general == "on" && matches!(special, "sort" | "segments")
        };
        if refines(there.value, required.value) {
            *there = required;
        } else if !refines(required.value, there.value) && self.conflicts.insert(key) {
            let message = format!(
                "{} requires `{key}` to be `{}`, but {} requires `{}`",
                required.by, required.value, there.by, there.value
            );
            let help = format!("let both require the same `{key}`, or drop one of them");
            let finding =
                Finding::new(Code::CONFLICTING_REQUIREMENTS, required.place.clone(), message, help);
            let related = format!("{} requires `{}` here", there.by, there.value);
            reader.findings.push(finding.with_related(there.place.clone(), related));
        }
    }
}

/// Reads `requires` and joins what nodes and nested phenomena require.
pub(super) fn check<'d>(
    reader: &mut Reader<'d>,
    value: Option<&'d Value>,
    draft: &Draft<'d>,
) -> Requirements {
    let mut requirements = Joined::default();
    if let Some(value) = value
        && let Some(members) = reader.members(value, "`requires`")
    {
        for member in members {
            read(reader, member, &mut requirements);
        }
    }
    for (at, node) in draft.nodes.iter().enumerate() {
        let Some(node_type) = node.node_type else { continue };
        if let Some(nested) = draft.nested.get(&node_type) {
            for (key, value) in &nested.graph.requirements.choices {
                let by = draft.described(at);
                let place = reader.document.place_of_key(node.member);
                requirements.join(reader, key, Required { value, by, place });
            }
            requirements.join_nested(&nested.graph.requirements);
        } else if let nodes::Kind::Request(effect) = draft.node_types.signature(node_type).kind
            && casts_rays(effect)
            && requirements.exclusive.get("trace").is_none_or(|it| it.value != "on")
        {
            let by = draft.described(at);
            let place = reader.document.place_of_key(node.member);
            requirements.join(reader, "trace", Required { value: "on", by, place });
        }
    }
    let requirements = requirements.finish();
    check_roots(reader, value, draft, &requirements);
    requirements
}

/// Reports roots of shader types the phenomenon says it is not for.
fn check_roots(
    reader: &mut Reader<'_>,
    value: Option<&Value>,
    draft: &Draft<'_>,
    requirements: &Requirements,
) {
    let Some(apply) = value.and_then(|value| value.get("apply")) else { return };
    for root in draft.roots.iter().filter(|root| !requirements.applies_to(root.kind)) {
        let name = root.kind.name();
        let message = format!("the phenomenon has a root `{name}`, but `apply` does not name it");
        let help = format!("add `{name}` to `apply`, or remove the root");
        let place = reader.document.place_of_key(root.member);
        let finding = Finding::new(Code::CONFLICTING_REQUIREMENTS, place, message, help);
        let apply = reader.document.place(apply);
        reader.findings.push(finding.with_related(apply, "what it may be used as"));
    }
}

/// Whether an effect needs ray tracing. Light samples cast shadow rays only where shadows are on.
fn casts_rays(effect: Effect) -> bool {
    matches!(effect.asked(), Asked::Rays(trace) if trace != Trace::Environment)
}

fn read<'d>(reader: &mut Reader<'d>, member: &'d Member, requirements: &mut Joined) {
    let value = &member.value;
    let what = format!("`{}`", shortened(&member.key));
    // Words exclude one another.
    if let Some(Key { name: key, kind: Kind::Word(words), .. }) = keys::REQUIRES.key(&member.key) {
        let choices: Vec<(&str, &'static str)> = words.iter().map(|it| (*it, *it)).collect();
        if let Some(value) = reader.choice(value, &what, &choices) {
            let place = reader.document.place(&member.value);
            let by = "the phenomenon".into();
            requirements.join(reader, key, Required { value, by, place });
        }
        return;
    }
    match member.key.as_str() {
        key @ ("texture" | "bump" | "volume_level") => {
            if let Some(count) = reader.integer(value, &what, 0..=1000_u32) {
                let of = match key {
                    "texture" => &mut requirements.rest.texture,
                    "bump" => &mut requirements.rest.bump,
                    _ => &mut requirements.rest.volume_level,
                };
                *of = count;
            }
        }
        "derivative" => {
            let orders = set(reader, value, &what, |reader, order| {
                reader.integer(order, "the order of a derivative", 1..=2_u8)
            });
            requirements.rest.derivative.extend(orders.unwrap_or_default());
        }
        "parallel" => requirements.rest.parallel = reader.boolean(value, &what),
        "apply" => {
            let choices = RootKind::ALL.map(|kind| (kind.name(), kind));
            // Where something is wrong with it, it may have been any.
            requirements.rest.apply = set(reader, value, &what, |reader, kind| {
                reader.choice(kind, "a shader type", &choices)
            });
        }
        _ => reader.unknown_key(member, "`requires`", &keys::REQUIRES.names()),
    }
}

/// A list of values, each once and at least one, which is all that is known of their number; none where one is wrong.
fn set<'d, T: Ord + Copy>(
    reader: &mut Reader<'d>,
    value: &'d Value,
    what: &str,
    mut element: impl FnMut(&mut Reader<'d>, &'d Value) -> Option<T>,
) -> Option<BTreeSet<T>> {
    let elements = reader.list(value, what)?;
    if elements.is_empty() {
        let help = format!("give at least one value, or leave {what} out");
        reader.report(Code::WRONG_LENGTH, value, format!("{what} is an empty list"), help);
        return None;
    }
    let mut seen = BTreeSet::new();
    let mut complete = true;
    for value in elements {
        match element(reader, value) {
            Some(element) if !seen.insert(element) => {
                let written = shortened(&reader.document.file.text[value.start..value.end]);
                let message = format!("{what} has `{written}` twice");
                reader.report(Code::DUPLICATE_KEY, value, message, "remove one of them");
            }
            Some(_) => {}
            None => complete = false,
        }
    }
    complete.then_some(seen)
}
