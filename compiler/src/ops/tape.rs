//! The recording back end: running a body on it appends operations to a tape.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use super::{Op, OpId};
use crate::emit::{Bits, Emit, Int, Mask, Real, Select, Sink, Words, standard_functions};

/// Operations in order, each recorded once: an operation already on the tape is found again.
#[derive(Debug, Default)]
pub struct Tape {
    inner: RefCell<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    ops: Vec<Op>,
    known: HashMap<Op, OpId>,
}

impl Tape {
    /// An empty tape.
    pub fn new() -> Self {
        Self::default()
    }

    /// Records `op`, or finds it.
    pub fn push(&self, op: Op) -> OpId {
        let mut inner = self.inner.borrow_mut();
        if let Some(&id) = inner.known.get(&op) {
            return id;
        }
        let id = inner.ops.len() as OpId;
        inner.ops.push(op);
        inner.known.insert(op, id);
        id
    }

    /// The operation at `id`.
    ///
    /// # Panics
    /// If nothing was recorded there.
    pub fn op(&self, id: OpId) -> Op {
        self.inner.borrow().ops[id as usize]
    }

    /// The operations so far.
    pub fn into_ops(self) -> Vec<Op> {
        self.inner.into_inner().ops
    }
}

/// A number on a tape.
#[derive(Clone, Copy, Debug)]
pub struct TapeReal<'t>(&'t Tape, OpId);
/// An integer on a tape.
#[derive(Clone, Copy, Debug)]
pub struct TapeInt<'t>(&'t Tape, OpId);
/// A truth value on a tape.
#[derive(Clone, Copy, Debug)]
pub struct TapeMask<'t>(&'t Tape, OpId);

impl<'t> Emit for &'t Tape {
    type Real = TapeReal<'t>;
    type Int = TapeInt<'t>;
    type Mask = TapeMask<'t>;
    fn real(self, value: f64) -> TapeReal<'t> {
        TapeReal(self, self.push(Op::Constant((value as f32).to_bits())))
    }
    fn int(self, value: i32) -> TapeInt<'t> {
        TapeInt(self, self.push(Op::Constant(value as u32)))
    }
    fn mask(self, value: bool) -> TapeMask<'t> {
        TapeMask(self, self.push(Op::Constant(if value { u32::MAX } else { 0 })))
    }
}

macro_rules! binary {
    ($type:ident: $($trait:ident $method:ident $op:ident),+) => {$(
        impl<'t> $trait for $type<'t> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0, self.0.push(Op::$op(self.1, other.1)))
            }
        }
    )+};
}
binary!(TapeReal: Add add Add, Sub sub Sub, Mul mul Mul, Div div Div);
binary!(TapeInt: Add add IntAdd, Sub sub IntSub, Mul mul IntMul, BitAnd bitand And, BitOr bitor Or, BitXor bitxor Xor);
binary!(TapeMask: BitAnd bitand And, BitOr bitor Or, BitXor bitxor Xor);

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl<'t> $trait<f64> for TapeReal<'t> {
            type Output = Self;
            fn $method(self, constant: f64) -> Self {
                self.$method(self.same(constant))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);

impl Neg for TapeReal<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0, self.0.push(Op::Neg(self.1)))
    }
}

impl Not for TapeMask<'_> {
    type Output = Self;
    fn not(self) -> Self {
        Self(self.0, self.0.push(Op::Not(self.1)))
    }
}

macro_rules! select {
    ($($type:ident),+) => {$(
        impl<'t> Select<TapeMask<'t>> for $type<'t> {
            fn select(mask: TapeMask<'t>, if_true: Self, if_false: Self) -> Self {
                Self(mask.0, mask.0.push(Op::Select(mask.1, if_true.1, if_false.1)))
            }
        }
    )+};
}
select!(TapeReal, TapeInt, TapeMask);

impl<'t> TapeReal<'t> {
    fn unary(self, op: Op) -> Self {
        Self(self.0, self.0.push(op))
    }
    fn compare(self, op: Op) -> TapeMask<'t> {
        TapeMask(self.0, self.0.push(op))
    }
}

impl<'t> Real for TapeReal<'t> {
    type Mask = TapeMask<'t>;
    type Int = TapeInt<'t>;
    fn same(self, value: f64) -> Self {
        self.unary(Op::Constant((value as f32).to_bits()))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self.unary(Op::MulAdd(self.1, factor.1, addend.1))
    }
    fn minimum(self, other: Self) -> Self {
        self.unary(Op::Minimum(self.1, other.1))
    }
    fn maximum(self, other: Self) -> Self {
        self.unary(Op::Maximum(self.1, other.1))
    }
    fn absolute(self) -> Self {
        self.unary(Op::Absolute(self.1))
    }
    fn sqrt(self) -> Self {
        self.unary(Op::Sqrt(self.1))
    }
    fn floor(self) -> Self {
        self.unary(Op::Floor(self.1))
    }
    fn ceil(self) -> Self {
        self.unary(Op::Ceil(self.1))
    }
    fn truncate(self) -> Self {
        self.unary(Op::Truncate(self.1))
    }
    fn round_even(self) -> Self {
        self.unary(Op::RoundEven(self.1))
    }
    fn less(self, other: Self) -> TapeMask<'t> {
        self.compare(Op::Less(self.1, other.1))
    }
    fn less_equal(self, other: Self) -> TapeMask<'t> {
        self.compare(Op::LessEqual(self.1, other.1))
    }
    fn equal(self, other: Self) -> TapeMask<'t> {
        self.compare(Op::Equal(self.1, other.1))
    }
    fn not_equal(self, other: Self) -> TapeMask<'t> {
        self.compare(Op::NotEqual(self.1, other.1))
    }
    fn to_int(self) -> TapeInt<'t> {
        TapeInt(self.0, self.0.push(Op::ToInt(self.1)))
    }
    standard_functions!();
}

impl<'t> Bits for TapeReal<'t> {
    fn to_bits(self) -> TapeInt<'t> {
        TapeInt(self.0, self.1)
    }
    fn from_bits(bits: TapeInt<'t>) -> Self {
        Self(bits.0, bits.1)
    }
}

impl<'t> TapeInt<'t> {
    fn unary(self, op: Op) -> Self {
        Self(self.0, self.0.push(op))
    }
}

impl<'t> Int for TapeInt<'t> {
    type Mask = TapeMask<'t>;
    type Real = TapeReal<'t>;
    fn same(self, value: i32) -> Self {
        self.unary(Op::Constant(value as u32))
    }
    fn shift_left(self, bits: u32) -> Self {
        self.unary(Op::ShiftLeft(self.1, bits))
    }
    fn shift_right(self, bits: u32) -> Self {
        self.unary(Op::ShiftRight(self.1, bits))
    }
    fn shift_right_signed(self, bits: u32) -> Self {
        self.unary(Op::ShiftRightSigned(self.1, bits))
    }
    fn equal(self, other: Self) -> TapeMask<'t> {
        TapeMask(self.0, self.0.push(Op::IntEqual(self.1, other.1)))
    }
    fn less(self, other: Self) -> TapeMask<'t> {
        TapeMask(self.0, self.0.push(Op::IntLess(self.1, other.1)))
    }
    fn to_real(self) -> TapeReal<'t> {
        TapeReal(self.0, self.0.push(Op::ToReal(self.1)))
    }
}

impl Mask for TapeMask<'_> {}

impl<'t> Words<&'t Tape> for (&'t Tape, &[OpId]) {
    fn real(&self, index: usize) -> TapeReal<'t> {
        TapeReal(self.0, self.1[index])
    }
    fn int(&self, index: usize) -> TapeInt<'t> {
        TapeInt(self.0, self.1[index])
    }
    fn mask(&self, index: usize) -> TapeMask<'t> {
        TapeMask(self.0, self.1[index])
    }
}

impl<'t> Sink<&'t Tape> for &mut [OpId] {
    fn real(&mut self, index: usize, value: TapeReal<'t>) {
        self[index] = value.1;
    }
    fn int(&mut self, index: usize, value: TapeInt<'t>) {
        self[index] = value.1;
    }
    fn mask(&mut self, index: usize, value: TapeMask<'t>) {
        self[index] = value.1;
    }
}
