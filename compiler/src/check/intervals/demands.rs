//! Under which conditions nodes are evaluated: what is true of a value wherever it may be read need
//! not be true where it is.
//!
//! `select(0 < d, 1 / d, 0)` never divides by zero: the division is evaluated where the condition
//! holds only. So a complaint about a node is made only if the guards on the way to it do not depend on
//! the sources the complaint is about.

use crate::check::draft::{Draft, SourceKind};
use crate::graph::Binding;

use super::slots::Slots;
use super::value::ANY_SOURCE;

/// What is known of guards.
#[derive(Default)]
pub struct Guards {
    /// The sources that decide whether an input is demanded, by slot and input.
    pub open: Vec<((usize, usize), u64)>,
    /// The inputs that never are, by slot and input.
    pub closed: Vec<(usize, usize)>,
}

impl Guards {
    /// Brings them in order, once all are known.
    pub fn sort(&mut self) {
        self.open.sort_unstable();
        self.closed.sort_unstable();
    }

    /// The sources that decide whether an input of a node that is evaluated is demanded.
    pub fn condition(&self, slot: usize, input: usize) -> u64 {
        match self.closed.binary_search(&(slot, input)) {
            Ok(_) => ANY_SOURCE,
            Err(_) => match self.open.binary_search_by_key(&(slot, input), |(at, _)| *at) {
                Ok(found) => self.open[found].1,
                Err(_) => 0,
            },
        }
    }
}

/// For each slot the sources that decide whether it is evaluated; none if it is somewhere
/// unconditionally. `order` has sources before what reads them.
pub fn conditions(
    draft: &Draft<'_>,
    slots: &Slots<'_>,
    order: &[usize],
    guards: &Guards,
) -> Vec<u64> {
    let mut conditions: Vec<Option<u64>> = vec![None; slots.count()];
    for source in draft.called() {
        if let SourceKind::Node(node, _) = source.kind {
            conditions[node] = Some(0);
        }
    }
    let demand = |conditions: &mut Vec<Option<u64>>, source: usize, under: u64| {
        if let Some(known) = conditions.get_mut(source) {
            *known = match *known {
                Some(0) => Some(0),
                Some(other) if under != 0 => Some(other | under),
                _ => Some(under),
            };
        }
    };
    // Of what is not bound it is not known when it reads.
    for node in (0..draft.nodes.len()).filter(|&node| slots.node(node).is_none()) {
        for (source, _) in draft.reads(node) {
            demand(&mut conditions, source, ANY_SOURCE);
        }
    }
    for &slot in order.iter().rev() {
        let Some(node) = slots.node(slot) else { continue };
        // What nothing reads is complained of as if it were.
        let own = *conditions[slot].get_or_insert(0);
        for (input, binding) in node.inputs.iter().enumerate() {
            if let Binding::Node { node: source, .. } = *binding {
                demand(&mut conditions, source, own | guards.condition(slot, input));
            }
        }
    }
    conditions.into_iter().map(|condition| condition.unwrap_or(ANY_SOURCE)).collect()
}
