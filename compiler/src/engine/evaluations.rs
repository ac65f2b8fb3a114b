//! Evaluations of nodes, counted where that is asked for.

use std::ops::AddAssign;

/// Evaluations of nodes: one is that of a node, at a point, in one turn of the loops round it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Evaluations {
    /// Those that were demanded.
    pub wanted: u64,
    /// Those that were made. The walk makes those that are demanded; other engines evaluate nodes that ask
    /// nothing for blocks of points, wanted by all of them or not.
    pub done: u64,
}

impl AddAssign for Evaluations {
    fn add_assign(&mut self, others: Self) {
        self.wanted += others.wanted;
        self.done += others.done;
    }
}
