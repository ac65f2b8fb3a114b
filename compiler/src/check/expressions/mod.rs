//! Expressions, written out as nodes before anything else is looked at: the passes of the checker, and the engines,
//! know of nodes only. What is found on a node that was written out of an expression has the place of the text it
//! came from.
//!
//! A phenomenon is gone through twice. The first time its names are resolved, with all findings thrown away, for an
//! expression becomes this node or that by the types of what it names. Then the expressions are written out, each after
//! what it names, and the phenomenon is checked with the nodes in their place.

mod calls;
mod components;
mod convert;
mod emit;
mod functions;
mod names;
mod operand;
mod operators;
mod order;
mod parsed;
mod rewrite;
mod sites;
mod write;
mod writer;
mod written;

pub(super) use convert::remedy;
pub use functions::{FUNCTIONS, Function, is_function};
pub use names::CONSTANTS;
pub(super) use written::Rewritten;

use std::cell::OnceCell;

use crate::document::{Reader, Value};
use crate::nodes::NodeLibrary;

use super::draft::Draft;
use super::types::Types;
use super::used_phenomena::Known;
use super::{interface, nodes, used_phenomena};

/// Room for what becomes of the expressions of a file and of each phenomenon in it.
pub(super) fn room(root: &Value) -> Vec<OnceCell<Rewritten>> {
    let mut count = 0;
    let mut pending = vec![root];
    while let Some(value) = pending.pop() {
        count += 1;
        let inner = value.get("phenomena").map_or(&[][..], Value::members);
        pending.extend(inner.iter().map(|member| &member.value));
    }
    std::iter::repeat_with(OnceCell::new).take(count).collect()
}

/// A phenomenon with nodes in the place of its expressions; none where it has no expressions.
pub(super) fn write_out<'d>(
    reader: &mut Reader<'d>,
    root: &'d Value,
    library: &'d NodeLibrary,
    known: Known<'_, 'd>,
) -> Option<Rewritten> {
    if !sites::any(root) {
        return None;
    }
    // What is wrong with it is told when it is checked.
    let mut unheard = Reader::of_part(reader.document);
    let mut draft = Draft::new(library, false);
    let nodes = root.get("nodes");
    let known = Known { named: &mut known.named.clone(), ..known };
    used_phenomena::declare(&mut unheard, nodes, &mut draft, known);
    interface::read(&mut unheard, root.get("interface"), &mut draft);
    nodes::read(&mut unheard, nodes, &mut draft)?;
    let sites = sites::find(root, &draft);
    let parsed = parsed::parse(reader, sites);
    let order = order::order(&draft, &parsed);
    let mut types = Types::unknown(&draft);
    let written = write::write(reader, &draft, &mut types, &parsed, &order);
    Some(rewrite::rewrite(root, parsed, written))
}
