//! Writing maps and folds out: a document in which each turn is a node.

use std::sync::Arc;

use crate::check::shape::element_name;
use crate::diagnostics::Finding;
use crate::document::{Document, Member, Value, ValueKind};
use crate::nodes::NodeLibrary;

use super::form::{ACCUMULATED, Form, INDEX, ITEM, OVER, form_of, written_name};
use super::repeats::{Left, Repeat, Repeats};
use super::uses::{self, inputs_written_out, with_value, written_out};

/// A document whose maps and folds are written out, and what is wrong with them: those that are not
/// understood stay. None for a document that has none.
pub fn unroll(document: &Document, library: &NodeLibrary) -> Option<(Document, Vec<Finding>)> {
    if !has_turns(&document.root) {
        return None;
    }
    let mut findings = Vec::new();
    let mut left = Left::of_file();
    let root = phenomenon(document, library, &document.root, (&mut left, &mut findings));
    let written = Some(Arc::new(document.root.clone()));
    Some((Document { file: document.file.clone(), root, written }, findings))
}

/// Whether a member is one that stands for another, which the file has in its place: a turn, or what a turn
/// is given.
pub fn is_implied(document: &Document, member: &Member) -> bool {
    let written = document.file.text.get(member.key_start + 1..member.key_end - 1);
    document.written.is_some()
        && written.is_some_and(|written| {
            let is_turn = written != member.key && written_name(&member.key) == written;
            is_turn
                || [ITEM, INDEX, ACCUMULATED].contains(&member.key.as_str())
                    && written != member.key
        })
}

fn has_turns(phenomenon: &Value) -> bool {
    let mut nodes = phenomenon.get("nodes").map_or(&[][..], Value::members).iter();
    let mut inner = phenomenon.get("phenomena").map_or(&[][..], Value::members).iter();
    nodes.any(|node| node.value.get("type").and_then(form_of).is_some())
        || inner.any(|member| has_turns(&member.value))
}

/// A phenomenon, and those within it, written out.
fn phenomenon(
    document: &Document,
    library: &NodeLibrary,
    value: &Value,
    (left, findings): (&mut Left, &mut Vec<Finding>),
) -> Value {
    let mut repeats = Repeats::of(document, library, value, left);
    uses::check(&mut repeats, document, library, value);
    findings.append(&mut repeats.findings);
    let ValueKind::Object(members) = &value.kind else { return value.clone() };
    let members = members.iter().map(|member| {
        let kind = match (member.key.as_str(), &member.value.kind) {
            ("nodes", ValueKind::Object(nodes)) => {
                ValueKind::Object(written_nodes(&repeats, nodes))
            }
            ("roots", ValueKind::Object(roots)) => {
                let root = |root: &Member| with_value(root, written_root(&repeats, &root.value));
                ValueKind::Object(roots.iter().map(root).collect())
            }
            ("phenomena", ValueKind::Object(inner)) => {
                let inner = inner.iter().map(|inner| {
                    let value = phenomenon(document, library, &inner.value, (left, findings));
                    with_value(inner, value)
                });
                ValueKind::Object(inner.collect())
            }
            (_, kind) => kind.clone(),
        };
        with_value(member, Value { kind, ..member.value })
    });
    let members: Vec<Member> = members.collect();
    Value { kind: ValueKind::Object(members), ..*value }
}

fn written_root(repeats: &Repeats<'_>, root: &Value) -> Value {
    match &root.kind {
        ValueKind::Object(_) if root.get("color").is_some() => inputs_written_out(repeats, root),
        _ => written_out(repeats, root),
    }
}

fn written_nodes(repeats: &Repeats<'_>, nodes: &[Member]) -> Vec<Member> {
    let mut written = Vec::with_capacity(nodes.len());
    for node in nodes {
        match repeats.all.get(node.key.as_str()) {
            Some(repeat) if std::ptr::eq(repeat.member, node) => {
                written.extend(turns(repeats, repeat));
            }
            _ => written.push(changed(node, |member| {
                (member.key == "inputs").then(|| inputs_written_out(repeats, &member.value))
            })),
        }
    }
    written
}

/// A node of which some members are changed: what is replaced is not copied first, for it may be a long
/// list.
fn changed(node: &Member, change: impl Fn(&Member) -> Option<Value>) -> Member {
    let ValueKind::Object(members) = &node.value.kind else { return node.clone() };
    let members = members.iter().map(|member| match change(member) {
        Some(value) => with_value(member, value),
        None => member.clone(),
    });
    with_value(node, Value { kind: ValueKind::Object(members.collect()), ..node.value })
}

/// A node for each turn.
fn turns<'r>(
    repeats: &'r Repeats<'_>,
    repeat: &'r Repeat<'_>,
) -> impl Iterator<Item = Member> + use<'r> {
    let name = repeat.member.key.as_str();
    let items = repeat.items.as_deref().unwrap_or_default();
    let name_of = move |at: usize| match repeat.form {
        // The last turn is what the fold yields.
        Form::Fold if at + 1 == items.len() => name.to_owned(),
        _ => element_name(name, at),
    };
    items.iter().enumerate().map(move |(at, item)| {
        let over = repeat.over;
        let number = Value { kind: ValueKind::Number(at.to_string()), ..over.value };
        let before = at.checked_sub(1).map(&name_of);
        let own = || {
            let mut own = vec![
                implied(ITEM, over, written_out(repeats, item)),
                implied(INDEX, over, number.clone()),
            ];
            if let Some(initial) = repeat.initial {
                let value = match &before {
                    None => written_out(repeats, &initial.value),
                    Some(before) => connection(&initial.value, before.clone()),
                };
                own.push(implied(ACCUMULATED, initial, value));
            }
            own
        };
        let is_own = |input: &Member| {
            input.key == OVER || repeat.initial.is_some_and(|initial| initial.key == input.key)
        };
        let mut node = changed(repeat.member, |member| match member.key.as_str() {
            "type" => Some(repeat.body.clone()),
            "inputs" => {
                let others = member.value.members().iter().filter(|input| !is_own(input));
                let others =
                    others.map(|input| with_value(input, written_out(repeats, &input.value)));
                let inputs = own().into_iter().chain(others).collect();
                Some(Value { kind: ValueKind::Object(inputs), ..member.value })
            }
            _ => None,
        });
        node.key = name_of(at);
        node
    })
}

/// A member that stands in the place of another.
fn implied(key: &str, of: &Member, value: Value) -> Member {
    Member { key: key.to_owned(), key_start: of.key_start, key_end: of.key_end, value }
}

/// A connection to a node, in the place of another value.
fn connection(at: &Value, node: String) -> Value {
    let name = Value { kind: ValueKind::String(node), ..*at };
    let member = Member { key: "node".into(), key_start: at.start, key_end: at.end, value: name };
    Value { kind: ValueKind::Object(vec![member]), ..*at }
}
