//! Nodes no root reaches, and parameters nothing reads.

use std::collections::HashSet;

use crate::diagnostics::{Code, Finding, shortened};
use crate::document::{Reader, ValueKind};
use crate::values::Type;

use super::draft::{Draft, DraftInput, DraftNode, Source, SourceKind};
use super::turns::written_name;

/// Reports the nodes at the top of what no root reaches, and the unused parameters. Says nothing
/// where a connection could not be resolved: it may be the one that is missing.
pub(super) fn check(reader: &mut Reader<'_>, draft: &Draft<'_>) {
    if !is_resolved(draft) {
        return;
    }
    unreachable_nodes(reader, draft);
    let mut used = vec![false; draft.parameters.len()];
    let inputs = draft.nodes.iter().flat_map(|node| &node.inputs).map(|input| &input.source);
    for source in inputs.chain(draft.called()) {
        if let SourceKind::Parameter(parameter) = source.kind {
            used[parameter] = true;
        }
    }
    // The elements of an array share a declaration: reading one of them reads it.
    let declared = |at: usize| draft.parameters[at].member.key_start;
    let read: HashSet<usize> = (0..used.len()).filter(|at| used[*at]).map(declared).collect();
    let mut told = HashSet::new();
    for (at, parameter) in draft.parameters.iter().enumerate() {
        if !read.contains(&declared(at)) && told.insert(declared(at)) {
            let name = shortened(&any_element(&parameter.name));
            let place = reader.document.place_of_key(parameter.member);
            let message = format!("nothing reads parameter `{name}`");
            let help = format!("connect it with `{{ \"interface\": \"{name}\" }}`, or remove it");
            reader.findings.push(Finding::new(Code::UNUSED_PARAMETER, place, message, help));
        }
    }
}

/// Whether every connection that was meant is known.
fn is_resolved(draft: &Draft<'_>) -> bool {
    let rootless = draft.roots.is_empty() && draft.outputs.is_empty()
        || draft.roots.iter().any(|root| root.colors.is_empty());
    let is_text = |node: &DraftNode<'_>, input: &DraftInput<'_>| {
        let signature = node.node_type.map(|node_type| draft.node_types.signature(node_type));
        let declared = signature.zip(input.input).map(|(of, at)| &of.inputs[at]);
        declared.is_some_and(|declared| declared.value_type == Type::String)
    };
    let mut inputs =
        draft.nodes.iter().flat_map(|node| node.inputs.iter().map(move |input| (node, input)));
    let mut called = draft.called();
    !draft.unresolved.get()
        && !rootless
        && inputs.all(|(node, input)| is_known(&input.source, is_text(node, input)))
        && called.all(|source| is_known(source, false))
}

/// Whether it is known what a source leads to.
fn is_known(source: &Source<'_>, is_text: bool) -> bool {
    match source.kind {
        // A whole array or struct where one value is due made a finding; any part may be meant.
        SourceKind::Broken | SourceKind::Compound(_) => false,
        SourceKind::Parameter(_) | SourceKind::Node(..) => true,
        // A string that is no literal was meant to connect, and so was a list with connections.
        SourceKind::Literal => match &source.value.kind {
            ValueKind::String(_) => is_text,
            ValueKind::Array(elements) => !elements
                .iter()
                .any(|element| element.get("node").or(element.get("interface")).is_some()),
            _ => true,
        },
    }
}

fn unreachable_nodes(reader: &mut Reader<'_>, draft: &Draft<'_>) {
    let mut reached = vec![false; draft.nodes.len()];
    for (node, _) in draft.evaluated(draft.called()) {
        reached[node] = true;
    }
    // What only an unreached node reads is unreached because of it: only the tops are told.
    let mut read = vec![false; draft.nodes.len()];
    for node in (0..draft.nodes.len()).filter(|&node| !reached[node]) {
        for (source, _) in draft.reads(node) {
            read[source] = true;
        }
    }
    // Of a map whose turns are reached in part, what is not asked for is no mistake.
    let called = |node: usize| written_name(draft.name(node));
    let known: HashSet<&str> =
        (0..draft.nodes.len()).filter(|&node| reached[node]).map(called).collect();
    for node in 0..draft.nodes.len() {
        if !reached[node] && !read[node] && !known.contains(called(node)) {
            let (what, help) = match draft.is_written(draft.name(node)) {
                true => (draft.described_output(node, 0), "nothing rests on it: remove it"),
                false => (
                    format!("node `{}`", draft.told_name(node)),
                    "connect one of its outputs, or remove it",
                ),
            };
            let place = reader.document.place_of_key(draft.nodes[node].member);
            let nothing = if draft.outputs.is_empty() { "no root" } else { "no root or output" };
            let message = format!("{nothing} reaches {what}, so it is never evaluated");
            reader.findings.push(Finding::new(Code::UNREACHABLE_NODE, place, message, help));
        }
    }
}

/// The name of a part for all elements of the arrays it is in: `layers[…].tint`.
fn any_element(name: &str) -> String {
    let mut all = String::with_capacity(name.len());
    let mut inside = false;
    for c in name.chars() {
        match c {
            '[' => all.push_str("[…"),
            _ if inside && c != ']' => {}
            _ => all.push(c),
        }
        inside = c == '[' || inside && c != ']';
    }
    all
}
