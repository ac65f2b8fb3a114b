//! One operation, and the pure segment it stands in.

use crate::storage::Source;

/// Position of an operation on its tape; operands come before.
pub type OpId = u32;

/// One operation on words. Every variant is an operation of [`crate::emit::Emit`]; see
/// `docs/numerics.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the operation of the same name in `emit`")]
pub enum Op {
    /// The word of a source, numbered by whoever records.
    Load(u32),
    /// These bits in every lane.
    Constant(u32),
    Add(OpId, OpId),
    Sub(OpId, OpId),
    Mul(OpId, OpId),
    Div(OpId, OpId),
    Neg(OpId),
    MulAdd(OpId, OpId, OpId),
    Minimum(OpId, OpId),
    Maximum(OpId, OpId),
    Absolute(OpId),
    Sqrt(OpId),
    Floor(OpId),
    Ceil(OpId),
    Truncate(OpId),
    RoundEven(OpId),
    Less(OpId, OpId),
    LessEqual(OpId, OpId),
    Equal(OpId, OpId),
    NotEqual(OpId, OpId),
    ToInt(OpId),
    IntAdd(OpId, OpId),
    IntSub(OpId, OpId),
    IntMul(OpId, OpId),
    And(OpId, OpId),
    Or(OpId, OpId),
    Xor(OpId, OpId),
    Not(OpId),
    ShiftLeft(OpId, u32),
    ShiftRight(OpId, u32),
    ShiftRightSigned(OpId, u32),
    IntEqual(OpId, OpId),
    IntLess(OpId, OpId),
    ToReal(OpId),
    /// Mask, value where true, value where false.
    Select(OpId, OpId, OpId),
}

impl Op {
    /// The same operation on operands renamed by `rename`, which is called in operand order.
    pub fn map_operands(self, mut rename: impl FnMut(OpId) -> OpId) -> Self {
        let mut r = |id| rename(id);
        match self {
            Op::Load(_) | Op::Constant(_) => self,
            Op::Add(a, b) => Op::Add(r(a), r(b)),
            Op::Sub(a, b) => Op::Sub(r(a), r(b)),
            Op::Mul(a, b) => Op::Mul(r(a), r(b)),
            Op::Div(a, b) => Op::Div(r(a), r(b)),
            Op::Neg(a) => Op::Neg(r(a)),
            Op::MulAdd(a, b, c) => Op::MulAdd(r(a), r(b), r(c)),
            Op::Minimum(a, b) => Op::Minimum(r(a), r(b)),
            Op::Maximum(a, b) => Op::Maximum(r(a), r(b)),
            Op::Absolute(a) => Op::Absolute(r(a)),
            Op::Sqrt(a) => Op::Sqrt(r(a)),
            Op::Floor(a) => Op::Floor(r(a)),
            Op::Ceil(a) => Op::Ceil(r(a)),
            Op::Truncate(a) => Op::Truncate(r(a)),
            Op::RoundEven(a) => Op::RoundEven(r(a)),
            Op::Less(a, b) => Op::Less(r(a), r(b)),
            Op::LessEqual(a, b) => Op::LessEqual(r(a), r(b)),
            Op::Equal(a, b) => Op::Equal(r(a), r(b)),
            Op::NotEqual(a, b) => Op::NotEqual(r(a), r(b)),
            Op::ToInt(a) => Op::ToInt(r(a)),
            Op::IntAdd(a, b) => Op::IntAdd(r(a), r(b)),
            Op::IntSub(a, b) => Op::IntSub(r(a), r(b)),
            Op::IntMul(a, b) => Op::IntMul(r(a), r(b)),
            Op::And(a, b) => Op::And(r(a), r(b)),
            Op::Or(a, b) => Op::Or(r(a), r(b)),
            Op::Xor(a, b) => Op::Xor(r(a), r(b)),
            Op::Not(a) => Op::Not(r(a)),
            Op::ShiftLeft(a, bits) => Op::ShiftLeft(r(a), bits),
            Op::ShiftRight(a, bits) => Op::ShiftRight(r(a), bits),
            Op::ShiftRightSigned(a, bits) => Op::ShiftRightSigned(r(a), bits),
            Op::IntEqual(a, b) => Op::IntEqual(r(a), r(b)),
            Op::IntLess(a, b) => Op::IntLess(r(a), r(b)),
            Op::ToReal(a) => Op::ToReal(r(a)),
            Op::Select(mask, a, b) => Op::Select(r(mask), r(a), r(b)),
        }
    }

    /// Calls `visit` with every operand, in order.
    pub fn for_each_operand(self, mut visit: impl FnMut(OpId)) {
        self.map_operands(|id| {
            visit(id);
            id
        });
    }

    /// Whether it only fetches a word: cheaper to repeat than to keep.
    pub fn is_fetch(self) -> bool {
        matches!(self, Op::Load(_) | Op::Constant(_))
    }
}

/// A pure piece of a shader program: what is computed between two requests.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OpSegment {
    /// The operations; operands come before their users.
    pub ops: Vec<Op>,
    /// What [`Op::Load`] reads: `Load(n)` is `sources[n]`.
    pub sources: Vec<Source>,
    /// The slots written, and with what. All loads happen before the first store.
    pub stores: Vec<(u32, OpId)>,
}
