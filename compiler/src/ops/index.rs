//! Where on a tape an operation stands, found by the operation.

use std::hash::{Hash, Hasher};

use rustc_hash::FxHasher;

use super::{Op, OpId};

/// Nothing stands here.
const EMPTY: OpId = OpId::MAX;

/// Positions in open addressing, one word each: the operations themselves stay on the tape, which a map
/// of them would copy.
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
        let mask = self.places.len() - 1;
        let mut place = hash(op) & mask;
        loop {
            match self.places[place] {
                EMPTY => break,
                id if ops[id as usize] == op => return id,
                _ => place = (place + 1) & mask,
            }
        }
        let id = ops.len() as OpId;
        self.places[place] = id;
        ops.push(op);
        id
    }

    #[cold]
    fn grow(&mut self, ops: &[Op]) {
        self.places = places(ops.len() + 1);
        let mask = self.places.len() - 1;
        for (id, &op) in ops.iter().enumerate() {
            let mut place = hash(op) & mask;
            while self.places[place] != EMPTY {
                place = (place + 1) & mask;
            }
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
            let all: Vec<Op> = (0..1000).map(Op::Constant).chain((0..1000).map(Op::Load)).collect();
            for _ in 0..2 {
                for (id, &op) in all.iter().enumerate() {
                    assert_eq!(index.find_or_push(&mut ops, op), id as OpId);
                }
            }
            assert_eq!(ops, all);
        }
    }
}
