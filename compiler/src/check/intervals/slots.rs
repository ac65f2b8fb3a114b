//! The nodes as they are bound, and the order to go through them.
//!
//! A node over a list is bound as several nodes, of which one stands in its place. Bindings name nodes
//! by *slots*: first those of the file, then the ones that were added.

use crate::check::draft::Draft;
use crate::graph::{Binding, Node};
use crate::nodes::Kind;

/// Where the bound nodes are.
pub struct Slots<'n> {
    nodes: &'n [Node],
    /// For each node of the file its position among the bound ones; none if it is not bound.
    own: Vec<Option<usize>>,
    /// Position of the first node that was added.
    added: usize,
}

impl<'n> Slots<'n> {
    /// The slots of `nodes`: those of the draft that could be bound, in its order, and those added.
    pub fn of(draft: &Draft<'_>, nodes: &'n [Node]) -> Self {
        let mut next = 0;
        let own = draft.nodes.iter().map(|drafted| {
            let node_type = drafted.node_type?;
            let list = matches!(draft.node_types.signature(node_type).kind, Kind::List(_));
            let bound = nodes.get(next)?;
            // One over a list that is not understood is left out.
            let there = bound.name == drafted.member.key && (list || bound.node_type == node_type);
            there.then(|| {
                next += 1;
                next - 1
            })
        });
        let own = own.collect();
        Self { nodes, own, added: next }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.own.len() + self.nodes.len() - self.added
    }

    /// The node in a slot.
    pub fn node(&self, slot: usize) -> Option<&'n Node> {
        let position = match slot.checked_sub(self.own.len()) {
            Some(added) => self.added + added,
            None => self.own[slot]?,
        };
        self.nodes.get(position)
    }

    /// All slots that are bound, sources before what reads them, for nodes of the file in that
    /// order. Added nodes stand before the one they were added for.
    pub fn ordered(&self, order: &[usize]) -> Vec<usize> {
        let mut all = Vec::with_capacity(self.count());
        let mut done = vec![false; self.count()];
        for &slot in order {
            let Some(node) = self.node(slot) else { continue };
            // Those of one list read one another, later ones the earlier, and nodes of the file.
            let mut added = Vec::new();
            let mut pending: Vec<usize> = self.added_sources(node).collect();
            while let Some(slot) = pending.pop() {
                if let Some(node) = self.node(slot)
                    && !std::mem::replace(&mut done[slot], true)
                {
                    added.push(slot);
                    pending.extend(self.added_sources(node));
                }
            }
            added.sort_unstable();
            all.append(&mut added);
            all.push(slot);
        }
        all
    }

    /// The added nodes that a node reads.
    fn added_sources(&self, node: &'n Node) -> impl Iterator<Item = usize> + use<'n> {
        let (first, count) = (self.own.len(), self.count());
        node.inputs.iter().filter_map(move |input| match input {
            Binding::Node { node, .. } if (first..count).contains(node) => Some(*node),
            _ => None,
        })
    }
}
