//! Exact folding: what gives the same bits for every input (NaNs are one class), and nothing else.
//!
//! `x + 0` stays (it turns -0 into 0), `x * 0` stays (NaN, infinities, -0), `x - x`, `x / x` and
//! `x == x` stay (NaN), `!(a < b)` is not `b <= a` (NaN).

use super::{Op, OpId, OpSegment, Tape};
use crate::emit::scalar::{Bool, F32, I32};
use crate::emit::{Int, Mask, Real};

const ONE: u32 = 0x3f80_0000;
const MINUS_ONE: u32 = 0xbf80_0000;
const ZERO: u32 = 0;
const MINUS_ZERO: u32 = 0x8000_0000;
const ALL: u32 = u32::MAX;

/// The segment folded; dead operations stay, see [`super::dead`].
pub fn fold(segment: &OpSegment) -> OpSegment {
    let tape = Tape::new();
    let mut new_id: Vec<OpId> = Vec::with_capacity(segment.ops.len());
    for &op in &segment.ops {
        let id = push(&tape, op.map_operands(|id| new_id[id as usize]));
        new_id.push(id);
    }
    let stores = segment.stores.iter().map(|&(slot, id)| (slot, new_id[id as usize])).collect();
    OpSegment { ops: tape.into_ops(), sources: segment.sources.clone(), stores }
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
    tape.push(in_order(op))
}

/// Operands of commutative operations in order, so that value numbering finds both.
fn in_order(op: Op) -> Op {
    let sorted = |a: OpId, b: OpId| (a.min(b), a.max(b));
    match op {
        Op::Add(a, b) => {
            let (a, b) = sorted(a, b);
            Op::Add(a, b)
        }
        Op::Mul(a, b) => {
            let (a, b) = sorted(a, b);
            Op::Mul(a, b)
        }
        Op::MulAdd(a, b, c) => {
            let (a, b) = sorted(a, b);
            Op::MulAdd(a, b, c)
        }
        Op::Equal(a, b) => {
            let (a, b) = sorted(a, b);
            Op::Equal(a, b)
        }
        Op::NotEqual(a, b) => {
            let (a, b) = sorted(a, b);
            Op::NotEqual(a, b)
        }
        Op::IntAdd(a, b) => {
            let (a, b) = sorted(a, b);
            Op::IntAdd(a, b)
        }
        Op::IntMul(a, b) => {
            let (a, b) = sorted(a, b);
            Op::IntMul(a, b)
        }
        Op::And(a, b) => {
            let (a, b) = sorted(a, b);
            Op::And(a, b)
        }
        Op::Or(a, b) => {
            let (a, b) = sorted(a, b);
            Op::Or(a, b)
        }
        Op::Xor(a, b) => {
            let (a, b) = sorted(a, b);
            Op::Xor(a, b)
        }
        Op::IntEqual(a, b) => {
            let (a, b) = sorted(a, b);
            Op::IntEqual(a, b)
        }
        other => other,
    }
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
    if !all {
        return None;
    }
    let word = |id| bits(tape, id).unwrap_or(0);
    let real = |id| F32(f32::from_bits(word(id)));
    let int = |id| I32(word(id) as i32);
    let from_real = |value: F32| value.0.to_bits();
    let from_int = |value: I32| value.0 as u32;
    let from_mask = |value: Bool| if value.0 { ALL } else { 0 };
    Some(match op {
        Op::Load(_) | Op::Constant(_) => return None,
        Op::Add(a, b) => from_real(real(a) + real(b)),
        Op::Sub(a, b) => from_real(real(a) - real(b)),
        Op::Mul(a, b) => from_real(real(a) * real(b)),
        Op::Div(a, b) => from_real(real(a) / real(b)),
        Op::Neg(a) => from_real(-real(a)),
        Op::MulAdd(a, b, c) => from_real(real(a).mul_add(real(b), real(c))),
        Op::Minimum(a, b) => from_real(real(a).minimum(real(b))),
        Op::Maximum(a, b) => from_real(real(a).maximum(real(b))),
        Op::Absolute(a) => from_real(real(a).absolute()),
        Op::Sqrt(a) => from_real(real(a).sqrt()),
        Op::Floor(a) => from_real(real(a).floor()),
        Op::Ceil(a) => from_real(real(a).ceil()),
        Op::Truncate(a) => from_real(real(a).truncate()),
        Op::RoundEven(a) => from_real(real(a).round_even()),
        Op::Less(a, b) => from_mask(real(a).less(real(b))),
        Op::LessEqual(a, b) => from_mask(real(a).less_equal(real(b))),
        Op::Equal(a, b) => from_mask(Real::equal(real(a), real(b))),
        Op::NotEqual(a, b) => from_mask(real(a).not_equal(real(b))),
        Op::ToInt(a) => from_int(real(a).to_int()),
        Op::IntAdd(a, b) => from_int(int(a) + int(b)),
        Op::IntSub(a, b) => from_int(int(a) - int(b)),
        Op::IntMul(a, b) => from_int(int(a) * int(b)),
        Op::And(a, b) => from_int(int(a) & int(b)),
        Op::Or(a, b) => from_int(int(a) | int(b)),
        Op::Xor(a, b) => from_int(int(a) ^ int(b)),
        Op::Not(a) => !word(a),
        Op::ShiftLeft(a, bits) => from_int(int(a).shift_left(bits)),
        Op::ShiftRight(a, bits) => from_int(int(a).shift_right(bits)),
        Op::ShiftRightSigned(a, bits) => from_int(int(a).shift_right_signed(bits)),
        Op::IntEqual(a, b) => from_mask(Int::equal(int(a), int(b))),
        Op::IntLess(a, b) => from_mask(Int::less(int(a), int(b))),
        Op::ToReal(a) => from_real(int(a).to_real()),
        Op::Select(mask, a, b) => from_int(Bool(word(mask) != 0).select(int(a), int(b))),
    })
}
