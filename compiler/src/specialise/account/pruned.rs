//! What inputs that are never evaluated leave out.

use crate::specialise::decisions::Decisions;
use crate::specialise::views::Views;

use super::part::TOLD_REASONS;

/// Which nodes are left out, and the inputs that are the last on the way to them.
pub(super) struct Pruned {
    connected: Vec<bool>,
    /// Of each node that is left out: of these inputs the first, one more than are told of.
    inputs: Vec<Vec<(usize, usize)>>,
}

impl Pruned {
    /// Each node is come to once for the root, and for as many inputs as are kept.
    pub fn of(views: &Views<'_>, decisions: &Decisions) -> Self {
        let mut connected = vec![false; views.len()];
        let mut stack = vec![views.root()];
        while let Some(view) = stack.pop() {
            if !std::mem::replace(&mut connected[view], true) {
                stack.extend((0..views.inputs(view)).filter_map(|input| views.source(view, input)));
            }
        }
        let mut folds: Vec<_> =
            decisions.folds.iter().map(|fold| (fold.view, fold.input)).collect();
        folds.sort_unstable();
        folds.dedup();
        let mut inputs: Vec<Vec<(usize, usize)>> = vec![Vec::new(); views.len()];
        for fold in folds {
            stack.extend(views.source(fold.0, fold.1));
            while let Some(view) = stack.pop() {
                // What leads on from a node that is evaluated is decided there.
                let known = &mut inputs[view];
                if decisions.built[view]
                    || known.len() > TOLD_REASONS
                    || known.last() == Some(&fold)
                {
                    continue;
                }
                known.push(fold);
                stack.extend((0..views.inputs(view)).filter_map(|input| views.source(view, input)));
            }
        }
        Self { connected, inputs }
    }

    /// Whether the root is connected to a node.
    pub fn is_connected(&self, view: usize) -> bool {
        self.connected[view]
    }

    /// Of the inputs that leave a node out, the first by node and position: one more than are told of.
    pub fn inputs(&self, view: usize) -> &[(usize, usize)] {
        &self.inputs[view]
    }
}
