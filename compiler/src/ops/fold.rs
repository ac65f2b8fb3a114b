//! Exact folding: what gives the same bits for every input (NaNs are one class), and nothing else.
//!
//! `x + 0` stays (it turns -0 into 0), `x * 0` stays (NaN, infinities, -0), `x - x`, `x / x` and
//! `x == x` stay (NaN), `!(a < b)` is not `b <= a` (NaN). Of segments that are
//! [legal](super::legalise) only: what of others is not in 32 bits stays as it is.

use super::apply::{Registers, apply};
use super::{Class, Op, OpId, OpSegment, Tape};
use crate::emit::scalar::{Bool, F32, I32, Scalar};

const ONE: u32 = 0x3f80_0000;
const MINUS_ONE: u32 = 0xbf80_0000;
const ZERO: u32 = 0;
const MINUS_ZERO: u32 = 0x8000_0000;
const ALL: u32 = u32::MAX;

/// The segment folded; dead operations stay, see [`super::dead`].
pub fn fold(segment: &OpSegment) -> OpSegment {
    let tape = Tape::with_capacity(segment.ops.len());
    let mut ids = Vec::new();
    onto(&tape, &segment.ops, |source| tape.push(Op::Load(source)), &mut ids);
    let stores = segment.stores.iter().map(|&(slot, id)| (slot, ids[id as usize])).collect();
    let (sources, wanted) = (segment.sources.clone(), segment.wanted.clone());
    OpSegment { ops: tape.into_ops(), sources, stores, wanted }
}

/// Records operations, folded, on `tape`, where `load` gives what [`Op::Load`] stands for. `ids` takes the
/// new position of each.
pub fn onto(tape: &Tape, ops: &[Op], mut load: impl FnMut(u32) -> OpId, ids: &mut Vec<OpId>) {
    ids.clear();
    ids.reserve(ops.len());
    for &op in ops {
        let id = match op {
            Op::Load(source) => load(source),
            op => push(tape, op.map_operands(|id| ids[id as usize])),
        };
        ids.push(id);
    }
}

/// What an operation is the same as.
enum Folded {
    /// It stays.
    Stays,
    /// A word already there.
    Word(OpId),
    /// These bits.
    Bits(u32),
    /// Another operation, which may fold again.
    Op(Op),
}

/// Records `op`, folded, on `tape`; its operands are on the tape already.
pub fn push(tape: &Tape, mut op: Op) -> OpId {
    // Every rewrite removes an operand, a sign or a Not, or moves towards an operation no rule
    // leaves; the bound only guards against a rule that breaks this.
    for _ in 0..16 {
        match fold_once(tape, op) {
            Folded::Stays => break,
            Folded::Word(id) => return id,
            Folded::Bits(bits) => return tape.push(Op::Constant(bits)),
            Folded::Op(other) => op = other,
        }
    }
    tape.push(op.in_order())
}

fn fold_once(tape: &Tape, op: Op) -> Folded {
    if let Some(bits) = constant(tape, op) {
        return Folded::Bits(bits);
    }
    match op {
        Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::Div(..) | Op::MulAdd(..) => {
            arithmetic(tape, op)
        }
        Op::IntAdd(..)
        | Op::IntSub(..)
        | Op::IntMul(..)
        | Op::And(..)
        | Op::Or(..)
        | Op::Xor(..)
        | Op::ShiftLeft(..)
        | Op::ShiftRight(..)
        | Op::ShiftRightSigned(..) => integer(tape, op),
        Op::Not(..) | Op::Select(..) => mask(tape, op),
        _ => other(tape, op),
    }
}

fn bits(tape: &Tape, id: OpId) -> Option<u32> {
    match tape.op(id) {
        Op::Constant(bits) => Some(bits),
        _ => None,
    }
}

fn negated(tape: &Tape, id: OpId) -> Option<OpId> {
    match tape.op(id) {
        Op::Neg(inner) => Some(inner),
        _ => None,
    }
}

fn arithmetic(tape: &Tape, op: Op) -> Folded {
    let constant = |id| bits(tape, id);
    let minus = |id| negated(tape, id);
    match op {
        Op::Add(a, b) => match (constant(a), constant(b), minus(a), minus(b)) {
            (Some(MINUS_ZERO), ..) => Folded::Word(b),
            (_, Some(MINUS_ZERO), ..) => Folded::Word(a),
            (_, _, _, Some(b)) => Folded::Op(Op::Sub(a, b)),
            (_, _, Some(a), _) => Folded::Op(Op::Sub(b, a)),
            _ => Folded::Stays,
        },
        Op::Sub(a, b) => match (constant(a), constant(b), minus(b)) {
            (_, Some(ZERO), _) => Folded::Word(a),
            (Some(MINUS_ZERO), ..) => Folded::Op(Op::Neg(b)),
            (_, _, Some(b)) => Folded::Op(Op::Add(a, b)),
            _ => Folded::Stays,
        },
        Op::Mul(a, b) => match (constant(a), constant(b), minus(a), minus(b)) {
            (Some(ONE), ..) => Folded::Word(b),
            (_, Some(ONE), ..) => Folded::Word(a),
            (Some(MINUS_ONE), ..) => Folded::Op(Op::Neg(b)),
            (_, Some(MINUS_ONE), ..) => Folded::Op(Op::Neg(a)),
            (_, _, Some(a), Some(b)) => Folded::Op(Op::Mul(a, b)),
            _ => Folded::Stays,
        },
        Op::Div(a, b) => match constant(b) {
            Some(ONE) => Folded::Word(a),
            Some(MINUS_ONE) => Folded::Op(Op::Neg(a)),
            Some(divisor) => match exact_reciprocal(divisor) {
                Some(factor) => Folded::Op(Op::Mul(a, tape.push(Op::Constant(factor)))),
                None => Folded::Stays,
            },
            None => Folded::Stays,
        },
        Op::MulAdd(a, b, c) => match (constant(a), constant(b), constant(c), minus(a), minus(b)) {
            (Some(ONE), ..) => Folded::Op(Op::Add(b, c)),
            (_, Some(ONE), ..) => Folded::Op(Op::Add(a, c)),
            (_, _, Some(MINUS_ZERO), ..) => Folded::Op(Op::Mul(a, b)),
            (_, _, _, Some(a), Some(b)) => Folded::Op(Op::MulAdd(a, b, c)),
            _ => Folded::Stays,
        },
        _ => Folded::Stays,
    }
}

/// The reciprocal of a power of two, if it is a normal number: dividing and multiplying then round
/// the same exact value.
fn exact_reciprocal(bits: u32) -> Option<u32> {
    let value = f32::from_bits(bits);
    let reciprocal = 1.0 / value;
    let power_of_two = value.is_normal() && bits & 0x7f_ffff == 0;
    (power_of_two && reciprocal.is_normal()).then_some(reciprocal.to_bits())
}

fn integer(tape: &Tape, op: Op) -> Folded {
    let constant = |id| bits(tape, id);
    match op {
        Op::ShiftLeft(a, 0) | Op::ShiftRight(a, 0) | Op::ShiftRightSigned(a, 0) => Folded::Word(a),
        Op::And(a, b) | Op::Or(a, b) if a == b => Folded::Word(a),
        Op::Xor(a, b) | Op::IntSub(a, b) if a == b => Folded::Bits(0),
        Op::IntSub(a, b) if constant(b) == Some(0) => Folded::Word(a),
        Op::IntAdd(a, b) | Op::IntMul(a, b) | Op::And(a, b) | Op::Or(a, b) | Op::Xor(a, b) => {
            let (value, word) = match (constant(a), constant(b)) {
                (Some(value), _) => (value, b),
                (_, Some(value)) => (value, a),
                _ => return Folded::Stays,
            };
            match (op, value) {
                (Op::IntAdd(..) | Op::Or(..) | Op::Xor(..), 0) => Folded::Word(word),
                (Op::And(..), ALL) | (Op::IntMul(..), 1) => Folded::Word(word),
                (Op::And(..) | Op::IntMul(..), 0) => Folded::Bits(0),
                (Op::Or(..), ALL) => Folded::Bits(ALL),
                (Op::Xor(..), ALL) => Folded::Op(Op::Not(word)),
                _ => Folded::Stays,
            }
        }
        _ => Folded::Stays,
    }
}

fn mask(tape: &Tape, op: Op) -> Folded {
    match op {
        Op::Not(a) => match tape.op(a) {
            Op::Not(inner) => Folded::Word(inner),
            Op::Equal(a, b) => Folded::Op(Op::NotEqual(a, b)),
            Op::NotEqual(a, b) => Folded::Op(Op::Equal(a, b)),
            _ => Folded::Stays,
        },
        Op::Select(mask, a, b) => match (tape.op(mask), bits(tape, a), bits(tape, b)) {
            _ if a == b => Folded::Word(a),
            (Op::Constant(bits), ..) => Folded::Word(if bits == 0 { b } else { a }),
            (_, Some(ALL), Some(0)) => Folded::Word(mask),
            (_, Some(0), Some(ALL)) => Folded::Op(Op::Not(mask)),
            (Op::Not(mask), ..) => Folded::Op(Op::Select(mask, b, a)),
            _ => Folded::Stays,
        },
        _ => Folded::Stays,
    }
}

fn other(tape: &Tape, op: Op) -> Folded {
    match op {
        Op::Neg(a) => negated(tape, a).map_or(Folded::Stays, Folded::Word),
        Op::Absolute(a) => match tape.op(a) {
            Op::Neg(inner) => Folded::Op(Op::Absolute(inner)),
            Op::Absolute(_) => Folded::Word(a),
            _ => Folded::Stays,
        },
        Op::Minimum(a, b) | Op::Maximum(a, b) if a == b => Folded::Word(a),
        Op::Less(a, b) | Op::IntLess(a, b) if a == b => Folded::Bits(0),
        Op::IntEqual(a, b) if a == b => Folded::Bits(ALL),
        Op::Floor(a) | Op::Ceil(a) | Op::Truncate(a) | Op::RoundEven(a) => match tape.op(a) {
            Op::Floor(_) | Op::Ceil(_) | Op::Truncate(_) | Op::RoundEven(_) | Op::ToReal(_) => {
                Folded::Word(a)
            }
            _ => Folded::Stays,
        },
        _ => Folded::Stays,
    }
}

/// The bits of an operation whose operands are all constant, by the scalar back end.
fn constant(tape: &Tape, op: Op) -> Option<u32> {
    if op.is_fetch() {
        return None;
    }
    let mut all = true;
    op.for_each_operand(|id| all &= bits(tape, id).is_some());
    all.then(|| apply(op, Scalar, &Constants(tape)))
}

/// The constants on a tape, as operands.
struct Constants<'t>(&'t Tape);

impl Constants<'_> {
    fn word(&self, id: OpId) -> u32 {
        bits(self.0, id).unwrap_or_default()
    }
}

impl Registers<Scalar> for Constants<'_> {
    type Word = u32;
    fn load(&self, _: u32) -> u32 {
        // Of what is not constant: never asked for.
        0
    }
    fn constant(&self, bits: u32) -> u32 {
        bits
    }
    fn class(&self, _: OpId) -> Class {
        // Bits are bits.
        Class::Int
    }
    fn real(&self, id: OpId) -> F32 {
        F32(f32::from_bits(self.word(id)))
    }
    fn int(&self, id: OpId) -> I32 {
        I32(self.word(id) as i32)
    }
    fn mask(&self, id: OpId) -> Bool {
        Bool(self.word(id) != 0)
    }
    fn of_real(&self, value: F32) -> u32 {
        value.0.to_bits()
    }
    fn of_int(&self, value: I32) -> u32 {
        value.0 as u32
    }
    fn of_mask(&self, value: Bool) -> u32 {
        if value.0 { ALL } else { 0 }
    }
}
