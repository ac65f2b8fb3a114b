//! Where maps are read: only what takes a list can read one.

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::{Document, Member, Value, ValueKind};
use crate::nodes::NodeLibrary;

use super::form::{Form, OVER, form_of};
use super::repeats::{Repeats, named, turn_of};

/// Whether an input of a node takes a list, or may: whether a phenomenon's is an array is seen when it
/// is known.
fn takes_list(library: &NodeLibrary, node: &Value, input: &str) -> bool {
    match node.get("type").map(|node_type| &node_type.kind) {
        Some(ValueKind::String(name)) => library.find(name).is_none_or(|node_type| {
            let mut inputs = library.signature(node_type).all_inputs();
            inputs.find(|known| known.name == input).is_none_or(|known| known.list)
        }),
        _ => true,
    }
}

/// Reports maps that are read where one value is due, and forgets them.
pub fn check(repeats: &mut Repeats<'_>, document: &Document, library: &NodeLibrary, of: &Value) {
    let mut wrong: Vec<(&Value, &str)> = Vec::new();
    let is_map = |name: &str| repeats.all.get(name).is_some_and(|it| it.form == Form::Map);
    for node in of.get("nodes").map_or(&[][..], Value::members) {
        for input in node.value.get("inputs").map_or(&[][..], Value::members) {
            let is_own = input.key == OVER && node.value.get("type").and_then(form_of).is_some();
            let list = is_own || takes_list(library, &node.value, &input.key);
            find(&input.value, list, &is_map, &mut wrong);
        }
    }
    for root in of.get("roots").map_or(&[][..], Value::members) {
        match root.value.get("color") {
            Some(color) => {
                find(color, true, &is_map, &mut wrong);
                root.value
                    .get("ok")
                    .into_iter()
                    .for_each(|ok| find(ok, false, &is_map, &mut wrong));
            }
            None => find(&root.value, true, &is_map, &mut wrong),
        }
    }
    for output in of.get("outputs").map_or(&[][..], Value::members) {
        find(&output.value, false, &is_map, &mut wrong);
    }
    let mut told: Vec<(Finding, String)> = Vec::new();
    for (value, name) in wrong {
        let count = repeats.all[name].items.as_ref().map_or(0, Vec::len);
        let told_name = shortened(name);
        let message =
            format!("one value is due, but the map `{told_name}` yields a list of {count}");
        let help = "take one of them with an `element` node, `sum` them, or `fold` over them";
        let place = document.place(value);
        told.push((Finding::new(Code::TYPE_MISMATCH, place, message, help), name.to_owned()));
    }
    for (finding, name) in told {
        repeats.findings.push(finding);
        repeats.forget(&name);
    }
}

/// Finds connections to maps in a value, which may be one itself where a list can be.
fn find<'v>(
    value: &'v Value,
    list: bool,
    is_map: &impl Fn(&str) -> bool,
    wrong: &mut Vec<(&'v Value, &'v str)>,
) {
    if let Some(name) = named(value) {
        if !list && is_map(name) {
            wrong.push((value, name));
        }
        return;
    }
    match &value.kind {
        ValueKind::Array(elements) => {
            elements.iter().for_each(|element| find(element, false, is_map, wrong));
        }
        ValueKind::Object(members) => {
            members.iter().for_each(|member| find(&member.value, false, is_map, wrong));
        }
        _ => {}
    }
}

/// A value with the lists in place of the maps that it connects.
pub fn written_out(repeats: &Repeats<'_>, value: &Value) -> Value {
    let Some(name) = named(value) else { return value.clone() };
    let Some(repeat) = repeats.all.get(name).filter(|it| it.form == Form::Map) else {
        return value.clone();
    };
    let turns = 0..repeat.items.as_ref().map_or(0, Vec::len);
    let turns = turns.map(|at| turn_of(value, name, at)).collect();
    Value { kind: ValueKind::Array(turns), ..*value }
}

/// The values of an object, the maps among them written out.
pub fn inputs_written_out(repeats: &Repeats<'_>, inputs: &Value) -> Value {
    let ValueKind::Object(members) = &inputs.kind else { return inputs.clone() };
    let members = members.iter().map(|input| with_value(input, written_out(repeats, &input.value)));
    Value { kind: ValueKind::Object(members.collect()), ..*inputs }
}

/// A member with another value.
pub fn with_value(member: &Member, value: Value) -> Member {
    let Member { key, key_start, key_end, .. } = member;
    Member { key: key.clone(), key_start: *key_start, key_end: *key_end, value }
}
