//! From recorded operations to those that machines of 32 bits have: functions are expanded as the
//! standard tier does, constants rounded to 32 bits and to untyped words.

use super::apply::{Registers, apply};
use super::tape::{TapeInt, TapeMask, TapeReal};
use super::{Class, Op, OpId, OpSegment, Tape};

/// The segment in operations of 32 bits, in the same order; what it has in common is found again.
pub fn legalise(segment: &OpSegment) -> OpSegment {
    let tape = Tape::standard();
    let mut replay = Replay { tape: &tape, ids: Vec::with_capacity(segment.ops.len()) };
    for &op in &segment.ops {
        let id = apply(op, &tape, &replay);
        replay.ids.push(id);
    }
    let ids = replay.ids;
    let stores = segment.stores.iter().map(|&(slot, id)| (slot, ids[id as usize])).collect();
    let (sources, wanted) = (segment.sources.clone(), segment.wanted.clone());
    OpSegment { ops: tape.into_ops(), sources, stores, wanted }
}

/// What was recorded on the other tape already.
struct Replay<'t> {
    tape: &'t Tape,
    ids: Vec<OpId>,
}

impl<'t> Registers<&'t Tape> for Replay<'t> {
    type Word = OpId;
    fn load(&self, source: u32) -> OpId {
        self.tape.push(Op::Load(source))
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
