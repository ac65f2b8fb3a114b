//! Arrays and structs: values by number or by name, to any depth. They exist in files only. The
//! checker takes them apart, so that every part is a parameter or an input of its own, called
//! `layers[2].tint`: the engines know no compound values, and an edit of one part is an edit of it
//! alone.

use std::collections::HashMap;

use crate::diagnostics::{Code, Finding, listed, shortened};
use crate::document::{Member, Reader, Value, ValueKind};

use super::draft::{Draft, Source, SourceKind};
use super::limits::MAX_NODES;
use super::shape::{Shape, element_name, member_name, struct_literal};
use super::type_names::with_article;
use super::{mismatch, sources};

/// Takes what is given for `shape` apart: one source for each part that is given, by name. Parts of a
/// struct may be left out.
pub(super) fn spread<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    shape: &Shape,
    (value, name): (&'d Value, &str),
    what: &str,
) -> Vec<(String, Source<'d>)> {
    let mut spread = Spread { reader, draft, what, parts: Vec::new() };
    spread.read(shape, value, name);
    spread.parts
}

/// What is given for an array or a struct, as it is taken apart.
struct Spread<'s, 'd> {
    reader: &'s mut Reader<'d>,
    draft: &'s Draft<'d>,
    what: &'s str,
    parts: Vec<(String, Source<'d>)>,
}

impl<'d> Spread<'_, 'd> {
    fn read(&mut self, shape: &Shape, value: &'d Value, name: &str) {
        if let Shape::One(_) = shape {
            let source = sources::read(self.reader, value, self.draft);
            self.parts.push((name.to_owned(), source));
            return;
        }
        if value.get("interface").is_some() {
            return self.connected(shape, value, name);
        }
        match (shape, &value.kind, struct_literal(value)) {
            (Shape::Array(elements), ValueKind::Array(given), _) => {
                if elements.len() != given.len() {
                    return self.wrong_length(shape, value, given.len(), name);
                }
                for (at, (element, given)) in elements.iter().zip(given).enumerate() {
                    self.read(element, given, &element_name(name, at));
                }
            }
            (Shape::Struct(members), _, Some(given)) => self.members(members, value, given, name),
            _ => {
                mismatch(self.reader, value, shape, self.what, &value.describe());
                self.broken(value, name);
            }
        }
    }

    /// Something is wrong, and told: nothing more is said of it.
    fn broken(&mut self, value: &'d Value, name: &str) {
        self.parts.push((name.to_owned(), Source::new(value, SourceKind::Broken)));
    }

    fn wrong_length(&mut self, shape: &Shape, value: &'d Value, given: usize, name: &str) {
        let (what, shape) = (self.what, shape.describe());
        let message = format!("{what} takes {shape}, but {given} values are given");
        let help = "an array has the length its default has; give as many values";
        self.reader.report(Code::WRONG_LENGTH, value, message, help);
        self.broken(value, name);
    }

    /// An array or a struct of the interface that is handed on.
    fn connected(&mut self, shape: &Shape, value: &'d Value, name: &str) {
        let draft = self.draft;
        match sources::read(self.reader, value, draft).kind {
            SourceKind::Compound(at) if draft.compounds[at].1.fits(shape) => {
                let wanted = shape.parts(name);
                if !take(self.reader, draft, value, wanted.len()) {
                    return self.broken(value, name);
                }
                let from = &draft.compounds[at].0;
                // Both have the same parts, if in another order: what follows their names agrees.
                for (to, _) in wanted {
                    let kind = draft.parameter_names.get(&format!("{from}{}", &to[name.len()..]));
                    let kind = kind.map_or(SourceKind::Broken, |at| SourceKind::Parameter(*at));
                    self.parts.push((to, Source::new(value, kind)));
                }
                return;
            }
            SourceKind::Compound(at) => self.other_parts(shape, value, &draft.compounds[at].1),
            SourceKind::Parameter(at) => {
                if let Some(value_type) = draft.parameters[at].value_type {
                    mismatch(self.reader, value, shape, self.what, &with_article(value_type));
                }
            }
            _ => {}
        }
        self.broken(value, name);
    }

    fn other_parts(&mut self, shape: &Shape, value: &Value, given: &Shape) {
        match given.difference(shape, "") {
            // Where the whole differs, that says it best.
            Some(difference) if !difference.starts_with("it must") => {
                let message = format!("{} takes other parts: {difference}", self.what);
                let help = "declare the same parts, of types that convert";
                self.reader.report(Code::TYPE_MISMATCH, value, message, help);
            }
            _ => mismatch(self.reader, value, shape, self.what, &given.describe()),
        }
    }

    fn members(
        &mut self,
        members: &[(String, Shape)],
        value: &'d Value,
        given: &'d Value,
        name: &str,
    ) {
        self.reader.object(value, "a struct", &["struct"]);
        let names: Vec<&str> = members.iter().map(|(name, _)| name.as_str()).collect();
        let by_name: HashMap<&str, &Shape> =
            members.iter().map(|(name, shape)| (name.as_str(), shape)).collect();
        for member in self.reader.members(given, "a struct").into_iter().flatten() {
            let Some(shape) = by_name.get(member.key.as_str()) else {
                unknown_member(self.reader, member, &names);
                self.broken(value, name);
                continue;
            };
            self.read(shape, &member.value, &member_name(name, &member.key));
        }
    }
}

/// Reports a member the struct does not have.
pub(super) fn unknown_member(reader: &mut Reader<'_>, member: &Member, names: &[&str]) {
    let advice = reader.advice(&member.key, names.iter().copied(), None, || {
        format!("its members are {}", listed(names.iter().copied()))
    });
    let message = format!("the struct has no member `{}`", shortened(&member.key));
    let place = reader.document.place_of_key(member);
    reader.findings.push(Finding::misspelt(Code::UNKNOWN_MEMBER, place, message, advice));
}

fn mismatch(reader: &mut Reader<'_>, value: &Value, shape: &Shape, what: &str, given: &str) {
    let given = format!("not {given}");
    mismatch::report(reader, value, (what, &shape.describe(), &given), shape.form());
}

/// What is given for the list of a node: one source for each value.
pub(super) fn list<'d>(
    reader: &mut Reader<'d>,
    draft: &Draft<'d>,
    value: &'d Value,
    what: &str,
) -> Vec<Source<'d>> {
    let broken = vec![Source::new(value, SourceKind::Broken)];
    if let ValueKind::Array(elements) = &value.kind {
        if elements.is_empty() {
            let help = "give at least one value";
            reader.report(Code::WRONG_LENGTH, value, format!("{what} is an empty list"), help);
            return broken;
        }
        if !take(reader, draft, value, elements.len()) {
            return broken;
        }
        return elements.iter().map(|element| sources::read(reader, element, draft)).collect();
    }
    let source = match &value.kind {
        ValueKind::Object(_) => sources::read(reader, value, draft),
        _ => Source::new(value, SourceKind::Literal),
    };
    let help = "write `[value, …]`, where a value may be a connection, or connect an array";
    let message = match source.kind {
        SourceKind::Broken => return broken,
        SourceKind::Compound(at) => match &draft.compounds[at] {
            (_, Shape::Array(elements)) if !take(reader, draft, value, elements.len()) => {
                return broken;
            }
            (name, Shape::Array(elements)) if is_flat(elements) => {
                let parts = Shape::Array(elements.clone()).parts(name);
                let parameters = parts.iter().map(|(name, _)| draft.parameter_names.get(name));
                return parameters
                    .map(|at| at.map_or(SourceKind::Broken, |at| SourceKind::Parameter(*at)))
                    .map(|kind| Source::new(value, kind))
                    .collect();
            }
            (name, shape) => {
                format!("{what} takes a list, but `{}` is {}", shortened(name), shape.describe())
            }
        },
        SourceKind::Literal => format!("{what} takes a list, not {}", value.describe()),
        // As its type did, or the map it is.
        SourceKind::Node(node, _) if draft.nodes[node].node_type.is_none() => return broken,
        // Its declaration made a finding.
        SourceKind::Parameter(at) if draft.parameters[at].value_type.is_none() => return broken,
        SourceKind::Parameter(_) | SourceKind::Node(..) => {
            format!("{what} takes a list, but one value is connected")
        }
    };
    reader.report(Code::TYPE_MISMATCH, value, message, help);
    broken
}

/// Takes values from what lists and arrays may give to nodes in all; a finding where that is too much.
fn take(reader: &mut Reader<'_>, draft: &Draft<'_>, value: &Value, count: usize) -> bool {
    let left = draft.values_left.get();
    if let Some(left) = left.checked_sub(count) {
        draft.values_left.set(left);
        return true;
    }
    // Told once: what comes after is as much too much.
    if left > 0 {
        draft.values_left.set(0);
        let message = format!("lists and arrays give nodes more than {MAX_NODES} values in all");
        let help = "hand over fewer or shorter arrays";
        reader.report(Code::TOO_MANY_NODES, value, message, help);
    }
    false
}

fn is_flat(elements: &[Shape]) -> bool {
    elements.iter().all(|element| matches!(element, Shape::One(_)))
}
