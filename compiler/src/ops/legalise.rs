//! From recorded operations to those that machines of 32 bits have: functions are expanded as the
//! standard tier does, constants rounded to 32 bits and to untyped words.

use super::apply::{Registers, apply};
use super::tape::{TapeInt, TapeMask, TapeReal};
use super::{Class, Op, OpId, OpSegment, Tape};

/// The segment in operations of 32 bits, in the same order; what it has in common is found again.
pub fn legalise(segment: &OpSegment) -> OpSegment {
    let tape = Tape::standard();
    let ids = replay(&segment.ops, &tape, |source| tape.push(Op::Load(source)));
    let stores = segment.stores.iter().map(|&(slot, id)| (slot, ids[id as usize])).collect();
    let (sources, wanted) = (segment.sources.clone(), segment.wanted.clone());
    OpSegment { ops: tape.into_ops(), sources, stores, wanted }
}

/// Records operations again, on another tape, where `load` gives what [`Op::Load`] stands for; for each
/// of them its new position.
pub fn replay(ops: &[Op], tape: &Tape, load: impl Fn(u32) -> OpId) -> Vec<OpId> {
    let mut replay = Replay { tape, load, ids: Vec::with_capacity(ops.len()) };
    for &op in ops {
        let id = apply(op, tape, &replay);
        replay.ids.push(id);
    }
    replay.ids
}

struct Replay<'t, L> {
    tape: &'t Tape,
    load: L,
    ids: Vec<OpId>,
}

impl<'t, L: Fn(u32) -> OpId> Registers<&'t Tape> for Replay<'t, L> {
    type Word = OpId;
    fn load(&self, source: u32) -> OpId {
        (self.load)(source)
    }
    fn constant(&self, bits: u32) -> OpId {
        self.tape.push(Op::Constant(bits))
    }
    fn class(&self, _: OpId) -> Class {
        // On a tape words have no class; all that works on words is defined for this one.
        Class::Mask
    }
    fn real(&self, id: OpId) -> TapeReal<'t> {
        self.tape.at(self.ids[id as usize])
    }
    fn int(&self, id: OpId) -> TapeInt<'t> {
        self.tape.at(self.ids[id as usize])
    }
    fn mask(&self, id: OpId) -> TapeMask<'t> {
        self.tape.at(self.ids[id as usize])
    }
    fn of_real(&self, value: TapeReal<'t>) -> OpId {
        value.id()
    }
    fn of_int(&self, value: TapeInt<'t>) -> OpId {
        value.id()
    }
    fn of_mask(&self, value: TapeMask<'t>) -> OpId {
        value.id()
    }
}
