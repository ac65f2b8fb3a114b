//! Where expressions stand.

use std::collections::HashMap;

use crate::check::draft::Draft;
use crate::document::{Value, ValueKind};

/// The sections in which connections stand, besides `nodes`.
const SECTIONS: [&str; 2] = ["roots", "outputs"];

/// A place with an expression.
pub(super) struct Site<'d> {
    /// The object.
    pub value: &'d Value,
    /// What the node is called that it becomes: no author's name has an `@`.
    pub name: String,
    /// The nodes whose input it is, or a part of one: all turns of a map or a fold, or one; none of a root.
    pub nodes: Vec<usize>,
}

/// Whether there is an expression where connections stand.
pub(super) fn any(root: &Value) -> bool {
    let nodes = root.get("nodes").map_or(&[][..], Value::members);
    let inputs = nodes.iter().filter_map(|node| node.value.get("inputs"));
    inputs.chain(SECTIONS.iter().filter_map(|section| root.get(section))).any(holds)
}

/// Whether a value is an expression, or holds one. Files are nested 64 deep at most.
fn holds(value: &Value) -> bool {
    match &value.kind {
        ValueKind::Array(elements) => elements.iter().any(holds),
        ValueKind::Object(members) => {
            members.iter().any(|member| member.key == "expression" || holds(&member.value))
        }
        _ => false,
    }
}

/// All of them, in file order. Those within others, under `where`, are part of these. What all turns of a map or a fold
/// are given is written once, and is one of them.
pub(super) fn find<'d>(root: &'d Value, draft: &Draft<'d>) -> Vec<Site<'d>> {
    let mut found = Found::default();
    for (at, node) in draft.nodes.iter().enumerate() {
        let inputs = node.member.value.get("inputs").map_or(&[][..], Value::members);
        for input in inputs.iter().filter(|input| holds(&input.value)) {
            let name = format!("{}@{}", node.member.key, input.key);
            found.walk(&input.value, name, Some(at));
        }
    }
    for section in SECTIONS {
        for member in root.get(section).map_or(&[][..], Value::members) {
            // An output that is one itself lacks its type, and that is told where outputs are read.
            if section == "outputs" && member.value.get("expression").is_some() {
                continue;
            }
            found.walk(&member.value, format!("@{section}.{}", member.key), None);
        }
    }
    found.sites
}

/// Those found so far, and their positions by where they start.
#[derive(Default)]
struct Found<'d> {
    sites: Vec<Site<'d>>,
    known: HashMap<usize, usize>,
}

impl<'d> Found<'d> {
    fn add(&mut self, value: &'d Value, name: String, node: Option<usize>) {
        let next = self.sites.len();
        let at = *self.known.entry(value.start).or_insert(next);
        if at == next {
            self.sites.push(Site { value, name, nodes: Vec::new() });
        }
        self.sites[at].nodes.extend(node);
    }

    fn walk(&mut self, value: &'d Value, name: String, node: Option<usize>) {
        if !holds(value) {
            return;
        }
        match &value.kind {
            ValueKind::Object(_) if value.get("expression").is_some() => {
                self.add(value, name, node);
            }
            ValueKind::Object(members) => {
                for member in members {
                    let name = match member.key.as_str() {
                        "struct" => name.clone(),
                        key => format!("{name}.{key}"),
                    };
                    self.walk(&member.value, name, node);
                }
            }
            ValueKind::Array(elements) => {
                for (at, element) in elements.iter().enumerate() {
                    self.walk(element, format!("{name}[{at}]"), node);
                }
            }
            _ => {}
        }
    }
}
