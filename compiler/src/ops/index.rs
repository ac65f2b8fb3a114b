//! Where on a tape an operation stands, found by the operation.

use std::hash::{Hash, Hasher};

use rustc_hash::FxHasher;

use super::{Op, OpId};

/// Nothing stands here.
const EMPTY: OpId = OpId::MAX;

/// Places looked at beside those of the operands, before the whole table is.
const NEAR: usize = 8;

/// Positions in open addressing, one word each: the operations themselves stay on the tape, which a map
/// of them would copy.
///
/// An operation stands near the place of its last operand, so that what is recorded one after the other
/// lies side by side: a table that scatters a long tape misses the cache at every step. Those of an
/// operand that very many share, and those without any, are scattered.
#[derive(Debug, Default)]
pub struct Index {
    /// A power of two of places, at most half of them taken; or none at all.
    places: Vec<OpId>,
}

impl Index {
    /// An index with room for that many operations.
    pub fn with_capacity(operations: usize) -> Self {
        if operations == 0 { Self::default() } else { Self { places: places(operations) } }
    }

    /// The position of `op` among `ops`; where it is new, it is appended.
    pub fn find_or_push(&mut self, ops: &mut Vec<Op>, op: Op) -> OpId {
        if (ops.len() + 1) * 2 > self.places.len() {
            self.grow(ops);
        }
        let place = self.place(op, |id| ops[id as usize] == op);
        let known = self.places[place];
        if known != EMPTY {
            return known;
        }
        let id = ops.len() as OpId;
        self.places[place] = id;
        ops.push(op);
        id
    }

    /// The place of `op`: the first that is free, or holds one that is the same. Nothing is ever taken out,
    /// so what stands in the table stands before the first free place.
    fn place(&self, op: Op, is_same: impl Fn(OpId) -> bool) -> usize {
        let mask = self.places.len() - 1;
        let found = |place: usize| self.places[place] == EMPTY || is_same(self.places[place]);
        let mut last = None;
        op.for_each_operand(|operand| last = last.max(Some(operand)));
        let near = last.map(|operand| (operand as usize * 2..).take(NEAR).map(|at| at & mask));
        if let Some(place) = near.into_iter().flatten().find(|&place| found(place)) {
            return place;
        }
        let mut place = hash(op) & mask;
        while !found(place) {
            place = (place + 1) & mask;
        }
        place
    }

    #[cold]
    fn grow(&mut self, ops: &[Op]) {
        self.places = places(ops.len() + 1);
        for (id, &op) in ops.iter().enumerate() {
            // All are different.
            let place = self.place(op, |_| false);
            self.places[place] = id as OpId;
        }
    }
}

/// Free places for at least that many operations.
fn places(operations: usize) -> Vec<OpId> {
    vec![EMPTY; (operations * 2).next_power_of_two().max(64)]
}

fn hash(op: Op) -> usize {
    let mut hasher = FxHasher::default();
    op.hash(&mut hasher);
    hasher.finish() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_operation_stands_once_however_many_there_are() {
        for capacity in [0, 1, 1000] {
            let (mut index, mut ops) = (Index::with_capacity(capacity), Vec::new());
            let fetches = (0..1000).map(Op::Constant).chain((0..1000).map(Op::Load));
            // Each of the operand before, and all of one operand.
            let users = (0..1000).flat_map(|id| [Op::Neg(id), Op::Add(id, 999), Op::Sub(999, id)]);
            let all: Vec<Op> = fetches.chain(users).collect();
            for _ in 0..2 {
                for (id, &op) in all.iter().enumerate() {
                    assert_eq!(index.find_or_push(&mut ops, op), id as OpId);
                }
            }
            assert_eq!(ops, all);
        }
    }
}
