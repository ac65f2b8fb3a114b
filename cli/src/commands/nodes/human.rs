//! Nodes as text for reading.

use std::fmt::Write;

use phenomenon_compiler::check::as_node;
use phenomenon_compiler::diagnostics::rounded;
use phenomenon_compiler::graph::Graph;
use phenomenon_compiler::nodes::{DefaultValue, Input, Kind, Signature};
use phenomenon_compiler::state::Iterated;
use phenomenon_compiler::values::Type;

use super::groups::{Group, first_sentence};
use super::search::{Found, Hit, Place};

/// Columns of running text.
const WIDTH: usize = 96;

/// Every group with its nodes, a line each.
pub fn groups(groups: &[Group<'_>]) -> String {
    let names = groups.iter().flat_map(|group| &group.nodes).map(|node| node.name.len());
    let column = names.max().unwrap_or(0);
    let mut text = String::new();
    for group in groups {
        let gap = if text.is_empty() { "" } else { "\n" };
        let _ = writeln!(text, "{gap}{}: {}", group.name, group.doc);
        for node in &group.nodes {
            let _ = writeln!(text, "  {:column$}  {}", node.name, first_sentence(&node.doc));
        }
    }
    text
}

/// The nodes that were found, a line each, with the input or output that has the word; then what to mind.
pub fn found(found: &Found<'_>) -> String {
    let column = found.hits.iter().map(|hit| hit.node.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for Hit { node, place } in &found.hits {
        let place = match place {
            Place::Input(name) => format!(" (input `{name}`)"),
            Place::Output(name) => format!(" (output `{name}`)"),
            Place::Exact | Place::Called | Place::Also | Place::Peer => " (by another name)".into(),
            Place::Name | Place::PartOfCalled | Place::PartOfName | Place::Doc => String::new(),
        };
        let doc = first_sentence(&node.doc);
        let _ = writeln!(text, "{:column$}  {doc}{place}", node.name);
    }
    if !found.advice.is_empty() {
        let _ = writeln!(text, "\nNote: {}", found.advice);
    }
    for (at, entry) in found.peers.iter().enumerate() {
        let gap = if at == 0 { "\n" } else { "" };
        let _ = writeln!(text, "{gap}{}", entry.answer());
    }
    text
}

/// All about one node.
pub fn node(node: &Signature) -> String {
    let mut text = format!("{} ({})\n\n", signature(node), node.group);
    paragraphs(&mut text, 0, &node.doc);
    if let Some(kind) = kind(&node.kind) {
        let _ = writeln!(text, "\n{kind}");
    }
    if !node.inputs.is_empty() {
        text.push_str("\nInputs\n");
    }
    for input in &node.inputs {
        let of = types(node, input.value_type);
        let _ = writeln!(text, "  {}: {of}{}", input.name, facts(input));
        paragraphs(&mut text, 6, &input.doc);
    }
    if let Some(list) = &node.or_list {
        let of = types(node, list.value_type);
        let _ = writeln!(text, "  or {}: list of {of}", list.name);
        paragraphs(&mut text, 6, &list.doc);
    }
    text.push_str("\nOutputs\n");
    for output in &node.outputs {
        let range = range(output.value_type, *output.range.start(), *output.range.end());
        let of = types(node, output.value_type);
        let _ = writeln!(text, "  {}: {of}{range}", output.name);
        paragraphs(&mut text, 6, &output.doc);
    }
    // Phenomena tell theirs in the doc, and what is common knowledge has none.
    if node.group != "phenomena" && !node.source.is_empty() {
        let _ = writeln!(text, "\nSource: {}", node.source);
    }
    text
}

/// All about a phenomenon as a node, and its presets.
pub fn phenomenon(graph: &Graph) -> String {
    let mut text = node(&as_node(graph, &graph.name));
    if !graph.presets.is_empty() {
        text.push_str("\nPresets\n");
    }
    for preset in &graph.presets {
        let values: Vec<String> =
            preset.values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let _ = writeln!(text, "  {}: {}", preset.name, values.join(", "));
    }
    text
}

fn types(node: &Signature, value_type: Type) -> String {
    node.types_of(value_type).iter().map(|of| of.name()).collect::<Vec<_>>().join(" | ")
}

fn signature(node: &Signature) -> String {
    let list = |names: Vec<&str>| names.join(", ");
    let inputs = list(node.inputs.iter().map(|input| &*input.name).collect());
    let outputs = list(node.outputs.iter().map(|output| &*output.name).collect());
    format!("{}({inputs}) -> {outputs}", node.name)
}

fn kind(kind: &Kind) -> Option<String> {
    match kind {
        Kind::Plain | Kind::Fields(_) => None,
        Kind::Request(effect) => Some(format!("Asks the renderer: {}.", effect.name())),
        Kind::Scope(fields) => {
            let names: Vec<&str> = fields.iter().map(|field| field.name()).collect();
            Some(format!("Changes for its scoped input: {}.", names.join(", ")))
        }
        Kind::List(_) => Some("Takes a list of any length.".into()),
        Kind::Loop(iterated, _) => {
            let what = match iterated {
                Iterated::Lights => "light sample",
                Iterated::Samples => "sample",
            };
            Some(format!("Evaluates its scoped input once for each {what}."))
        }
    }
}

fn facts(input: &Input) -> String {
    let mut facts = default(&input.default);
    facts.push_str(&range(input.value_type, *input.range.start(), *input.range.end()));
    if let Some(soft) = input.narrower() {
        facts.push_str(&format!(", usually {} to {}", soft.start(), soft.end()));
    }
    if !input.unit.is_empty() {
        facts.push_str(&format!(", in {}", input.unit));
    }
    if !input.choices.is_empty() {
        facts.push_str(&format!(", one of {}", input.choices.join(", ")));
    }
    if input.fixed {
        facts.push_str(", known before shading");
    }
    if input.guarded {
        facts.push_str(", evaluated only where needed");
    }
    if input.scoped {
        facts.push_str(", evaluated in the scope of this node");
    }
    facts
}

fn default(default: &DefaultValue) -> String {
    match default {
        DefaultValue::Required => ", must be given".into(),
        DefaultValue::Literal(literal) => format!(" = {literal}"),
        DefaultValue::State(field) => format!(" = state.{}", field.name()),
        DefaultValue::Node(name) => format!(" = {name}"),
    }
}

fn range(value_type: Type, low: f64, high: f64) -> String {
    if !value_type.is_numeric() {
        return String::new();
    }
    let most = if value_type == Type::Integer { i32::MAX.into() } else { f64::from(f32::MAX) };
    let (from, to) = (low > -f64::from(f32::MAX), high < most);
    let above_zero = low == f64::from(f32::MIN_POSITIVE);
    let (low, high) = (rounded(low), rounded(high));
    match (from, to) {
        (true, true) if above_zero => format!(", above 0, at most {high}"),
        (true, true) => format!(", {low} to {high}"),
        (true, false) if above_zero => ", above 0".into(),
        (true, false) => format!(", at least {low}"),
        (false, true) => format!(", at most {high}"),
        (false, false) => String::new(),
    }
}

fn paragraphs(text: &mut String, indent: usize, doc: &str) {
    let mut column = 0;
    for word in doc.split_whitespace() {
        let length = word.chars().count();
        if column > 0 && column + 1 + length > WIDTH {
            text.push('\n');
            column = 0;
        }
        if column == 0 {
            text.extend(std::iter::repeat_n(' ', indent));
            column = indent + length;
        } else {
            text.push(' ');
            column += 1 + length;
        }
        text.push_str(word);
    }
    text.push('\n');
}
