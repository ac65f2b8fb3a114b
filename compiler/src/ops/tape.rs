//! The recording back end: running a body on it appends operations to a tape.

use std::cell::RefCell;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use super::index::Index;
use super::{Number, Op, OpId};
use crate::emit::{Bits, Emit, Int, Mask, Real, Select, Sink, Table, Words, standard};

/// Operations in order, each recorded once: an operation already on the tape is found again.
#[derive(Debug, Default)]
pub struct Tape {
    inner: RefCell<Inner>,
    /// Whether functions are expanded, and constants rounded, as they come.
    standard: bool,
}

#[derive(Debug, Default)]
struct Inner {
    ops: Vec<Op>,
    index: Index,
}

impl Tape {
    /// An empty tape.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty tape with room for that many operations.
    pub fn with_capacity(operations: usize) -> Self {
        let index = Index::with_capacity(operations);
        let inner = RefCell::new(Inner { ops: Vec::with_capacity(operations), index });
        Self { inner, standard: false }
    }

    /// An empty tape of the standard tier's operations of 32 bits; see [`super::legalise`].
    pub fn standard() -> Self {
        Self { standard: true, ..Self::default() }
    }

    /// Records `op`, or finds it. Recorders are made of calls of it, one for each operation of each body:
    /// inlined, it would be most of what is compiled.
    #[inline(never)]
    pub fn push(&self, op: Op) -> OpId {
        let Inner { ops, index } = &mut *self.inner.borrow_mut();
        index.find_or_push(ops, op)
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

    /// What was recorded at `id`, as a value.
    pub(super) fn at<'t, T: OnTape<'t>>(&'t self, id: OpId) -> T {
        T::at(self, id)
    }

    fn record<'t, T: OnTape<'t>>(&'t self, op: Op) -> T {
        self.at(self.push(op))
    }

    #[inline(never)]
    fn number(&self, value: f64) -> OpId {
        self.push(match self.standard {
            true => Op::Constant((value as f32).to_bits()),
            false => Op::Number(Number::new(value)),
        })
    }

    #[inline(never)]
    fn integer(&self, value: i32) -> OpId {
        self.push(if self.standard { Op::Constant(value as u32) } else { Op::Integer(value) })
    }

    #[inline(never)]
    fn truth(&self, value: bool) -> OpId {
        let bits = if value { u32::MAX } else { 0 };
        self.push(if self.standard { Op::Constant(bits) } else { Op::Truth(value) })
    }
}

/// A value on a tape.
pub(super) trait OnTape<'t> {
    fn at(tape: &'t Tape, id: OpId) -> Self;
}

macro_rules! values {
    ($($(#[$doc:meta])* $type:ident;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $type<'t>(&'t Tape, OpId);

        impl $type<'_> {
            /// Its position.
            pub(super) fn id(self) -> OpId {
                self.1
            }
        }

        impl<'t> OnTape<'t> for $type<'t> {
            fn at(tape: &'t Tape, id: OpId) -> Self {
                Self(tape, id)
            }
        }

        impl<'t> Select<TapeMask<'t>> for $type<'t> {
            fn select(mask: TapeMask<'t>, if_true: Self, if_false: Self) -> Self {
                mask.0.record(Op::Select(mask.1, if_true.1, if_false.1))
            }
        }
    )+};
}
values! {
    /// A number on a tape.
    TapeReal;
    /// An integer on a tape.
    TapeInt;
    /// A truth value on a tape.
    TapeMask;
}

impl<'t> Emit for &'t Tape {
    type Real = TapeReal<'t>;
    type Int = TapeInt<'t>;
    type Mask = TapeMask<'t>;
    fn real(self, value: f64) -> TapeReal<'t> {
        self.at(self.number(value))
    }
    fn int(self, value: i32) -> TapeInt<'t> {
        self.at(self.integer(value))
    }
    fn mask(self, value: bool) -> TapeMask<'t> {
        self.at(self.truth(value))
    }
    fn table(self, table: Table, index: TapeInt<'t>) -> TapeReal<'t> {
        self.record(Op::Table(table, index.id()))
    }
}

/// The value type of a class.
macro_rules! of {
    (real $lifetime:lifetime) => { TapeReal<$lifetime> };
    (int $lifetime:lifetime) => { TapeInt<$lifetime> };
    (mask $lifetime:lifetime) => { TapeMask<$lifetime> };
}

macro_rules! bitwise {
    ($($type:ident: $trait:ident $method:ident $op:ident;)+) => {$(
        impl $trait for $type<'_> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.0.record(Op::$op(self.1, other.1))
            }
        }
    )+};
}
bitwise! {
    TapeInt: BitAnd bitand And;
    TapeInt: BitOr bitor Or;
    TapeInt: BitXor bitxor Xor;
    TapeMask: BitAnd bitand And;
    TapeMask: BitOr bitor Or;
    TapeMask: BitXor bitxor Xor;
}

impl Not for TapeMask<'_> {
    type Output = Self;
    fn not(self) -> Self {
        self.0.record(Op::Not(self.1))
    }
}

impl Neg for TapeReal<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.0.record(Op::Neg(self.1))
    }
}

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl $trait<f64> for TapeReal<'_> {
            type Output = Self;
            fn $method(self, constant: f64) -> Self {
                self.$method(self.same(constant))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);

/// One method of a trait: those of the other class, and operators of `std::ops`, are left out.
macro_rules! method {
    (real of real neg $($rest:tt)*) => {};
    (real of int $($rest:tt)*) => {};
    (int of real $($rest:tt)*) => {};
    ($class:ident of $same:ident $calls:ident $op:ident ($($operand:ident: $its:ident),*) -> $out:ident) => {
        fn $calls(self $(, $operand: of!($its 't))*) -> of!($out 't) {
            self.0.record(Op::$op(self.1 $(, $operand.1)*))
        }
    };
}

macro_rules! define {
    (
        operators { $($operator:ident $operator_name:literal $both:ident $trait:ident::$call:ident
            [$($operator_flag:ident)?];)+ }
        methods { $($method:ident $method_name:literal $of:ident.$calls:ident $operands:tt
            -> $out:ident [$($method_flag:ident)?];)+ }
        shifts { $($shift:ident $shift_calls:ident;)+ }
        words $words:tt
        functions { $($function:ident $function_calls:ident($($second:ident)?);)+ }
    ) => {
        $(impl<'t> $trait for of!($both 't) {
            type Output = Self;
            fn $call(self, other: Self) -> Self {
                self.0.record(Op::$operator(self.1, other.1))
            }
        })+

        impl<'t> Real for TapeReal<'t> {
            type Mask = TapeMask<'t>;
            type Int = TapeInt<'t>;
            fn same(self, value: f64) -> Self {
                self.0.at(self.0.number(value))
            }
            $(method! { real of $of $calls $method $operands -> $out })+
            $(fn $function_calls(self $(, $second: Self)?) -> Self {
                match self.0.standard {
                    true => standard::$function_calls(self $(, $second)?),
                    false => self.0.record(Op::$function(self.1 $(, $second.1)?)),
                }
            })+
        }

        impl<'t> Int for TapeInt<'t> {
            type Mask = TapeMask<'t>;
            type Real = TapeReal<'t>;
            fn same(self, value: i32) -> Self {
                self.0.at(self.0.integer(value))
            }
            $(fn $shift_calls(self, bits: u32) -> Self {
                self.0.record(Op::$shift(self.1, bits))
            })+
            $(method! { int of $of $calls $method $operands -> $out })+
        }
    };
}
operations! {define}

impl<'t> Bits for TapeReal<'t> {
    fn to_bits(self) -> TapeInt<'t> {
        self.0.at(self.1)
    }
    fn from_bits(bits: TapeInt<'t>) -> Self {
        bits.0.at(bits.1)
    }
}

impl Mask for TapeMask<'_> {}

/// The input words of a body that is recorded.
#[derive(Clone, Copy, Debug)]
pub struct TapeInputs<'t> {
    tape: &'t Tape,
    given: Option<&'t [OpId]>,
    fixed: &'t [(usize, i32)],
}

impl<'t> TapeInputs<'t> {
    /// Those recorded already.
    pub fn given(tape: &'t Tape, ids: &'t [OpId]) -> Self {
        Self { tape, given: Some(ids), fixed: &[] }
    }

    /// Input word `n` as `Load(n)`, recorded when it is first read.
    pub fn loads(tape: &'t Tape) -> Self {
        Self { tape, given: None, fixed: &[] }
    }

    /// With these words known before shading.
    pub fn with_fixed(self, fixed: &'t [(usize, i32)]) -> Self {
        Self { fixed, ..self }
    }

    /// The tape.
    pub fn tape(&self) -> &'t Tape {
        self.tape
    }

    fn word<T: OnTape<'t>>(&self, index: usize) -> T {
        self.tape.at(self.id(index))
    }

    #[inline(never)]
    fn id(&self, index: usize) -> OpId {
        match self.given {
            Some(ids) => ids[index],
            None => self.tape.push(Op::Load(index as u32)),
        }
    }
}

impl<'t> Words<&'t Tape> for TapeInputs<'t> {
    fn real(&self, index: usize) -> TapeReal<'t> {
        self.word(index)
    }
    fn int(&self, index: usize) -> TapeInt<'t> {
        self.word(index)
    }
    fn mask(&self, index: usize) -> TapeMask<'t> {
        self.word(index)
    }
    /// # Panics
    ///
    /// If it was not said: bodies with inputs known before shading are recorded for known numbers.
    #[inline(never)]
    fn fixed(&self, index: usize) -> i32 {
        let known = self.fixed.iter().find(|(word, _)| *word == index);
        known.expect("what is known before shading was said").1
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
