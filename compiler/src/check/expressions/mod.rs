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
pub use functions::{FUNCTIONS, Function};
pub(super) use written::Rewritten;

use crate::document::{Reader, Value};

use super::draft::Draft;
use super::phenomenon::Given;
use super::reachable::Named;
use super::types::Types;
use super::{interface, nodes, used_phenomena};

/// A phenomenon with nodes in the place of its expressions; none where it has no expressions.
pub(super) fn write_out<'d>(
    reader: &mut Reader<'d>,
    root: &'d Value,
    given: Given<'d>,
    named: &Named,
) -> Option<Rewritten> {
    if !sites::any(root) {
        return None;
    }
    // What is wrong with it is told when it is checked.
    let mut unheard = Reader::of_part(reader.document);
    let mut draft = Draft::new(given.library, false);
    let nodes = root.get("nodes");
    used_phenomena::declare(&mut unheard, nodes, &mut draft, named.clone(), given.checked);
    interface::read(&mut unheard, root.get("interface"), &mut draft);
    nodes::read(&mut unheard, nodes, &mut draft)?;
    let sites = sites::find(root, &draft);
    let parsed = parsed::parse(reader, sites);
    let order = order::order(&draft, &parsed);
    let mut types = Types::unknown(&draft);
    let written = write::write(reader, &draft, &mut types, &parsed, &order);
    Some(rewrite::rewrite(root, parsed, written))
}
