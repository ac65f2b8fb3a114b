//! The phenomenon with nodes in the place of its expressions.

use std::collections::HashMap;

use crate::document::{Member, Value, ValueKind};
use crate::graph::Expression;

use super::parsed::{Bound, Parsed};
use super::write::Written;
use super::written::Rewritten;

/// Puts what was written in its places. Expressions that could not be written stay; the checker says nothing of them.
pub(super) fn rewrite(root: &Value, parsed: Vec<Parsed<'_>>, written: Written) -> Rewritten {
    let mut expressions = Vec::new();
    parsed.iter().for_each(|parsed| list(parsed, &mut expressions));
    let places: HashMap<usize, Value> =
        written.places.into_iter().map(|(at, place)| (parsed[at].value.start, place)).collect();
    let mut root = root.clone();
    if let ValueKind::Object(members) = &mut root.kind {
        for member in members.iter_mut() {
            match member.key.as_str() {
                "nodes" | "roots" | "outputs" => replace(&mut member.value, &places),
                _ => {}
            }
        }
        add_nodes(members, written.output.members);
    }
    let mut spans = Vec::new();
    parsed.iter().for_each(|parsed| list_spans(parsed, &mut spans));
    spans.sort_unstable();
    Rewritten { root, texts: written.output.texts, expressions, spans }
}

/// The name and the text of an expression and of those within it.
fn list(parsed: &Parsed<'_>, into: &mut Vec<Expression>) {
    for (_, bound) in &parsed.bindings {
        if let Bound::Expression(inner) = bound {
            list(inner, into);
        }
    }
    into.push(Expression { name: parsed.name.clone(), text: parsed.text.to_owned() });
}

/// The places of the texts of an expression and of those within it.
fn list_spans(parsed: &Parsed<'_>, into: &mut Vec<(usize, usize)>) {
    for (_, bound) in &parsed.bindings {
        if let Bound::Expression(inner) = bound {
            list_spans(inner, into);
        }
    }
    let text = 0..parsed.text.len();
    into.push(parsed.place(&text));
}

/// Puts what expressions became in their places, which are found by where they start: all turns of a map read one.
fn replace(value: &mut Value, places: &HashMap<usize, Value>) {
    if let ValueKind::Object(_) = &value.kind
        && value.get("expression").is_some()
    {
        if let Some(place) = places.get(&value.start) {
            value.clone_from(place);
        }
        return;
    }
    match &mut value.kind {
        ValueKind::Array(elements) => elements.iter_mut().for_each(|it| replace(it, places)),
        ValueKind::Object(members) => {
            members.iter_mut().for_each(|member| replace(&mut member.value, places));
        }
        _ => {}
    }
}

/// Adds nodes behind those of the file.
fn add_nodes(members: &mut Vec<Member>, added: Vec<Member>) {
    let nodes = members.iter_mut().find(|member| member.key == "nodes");
    match nodes.map(|member| &mut member.value.kind) {
        Some(ValueKind::Object(nodes)) => nodes.extend(added),
        Some(_) => {}
        None if added.is_empty() => {}
        None => members.push(Member {
            key: "nodes".into(),
            key_start: 0,
            key_end: 0,
            value: Value { start: 0, end: 0, kind: ValueKind::Object(added) },
        }),
    }
}
