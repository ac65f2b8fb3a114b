//! Evaluation of operations over any back end: what a body does there, from what it recorded.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Class, Op, OpId};
use crate::emit::{Emit, Int, Mask, Real};

/// Where an evaluator keeps the words of operations, as values of the back end `E`.
pub trait Registers<E: Emit> {
    /// A word.
    type Word;
    /// The word of a source.
    fn load(&self, source: u32) -> Self::Word;
    /// The word of these bits.
    fn constant(&self, bits: u32) -> Self::Word;
    /// What the word of an operation is taken to mean where that does not follow from its user.
    fn class(&self, id: OpId) -> Class;
    /// The word of an operation as a number.
    fn real(&self, id: OpId) -> E::Real;
    /// As an integer.
    fn int(&self, id: OpId) -> E::Int;
    /// As a truth value.
    fn mask(&self, id: OpId) -> E::Mask;
    /// The word of a number.
    fn of_real(&self, value: E::Real) -> Self::Word;
    /// Of an integer.
    fn of_int(&self, value: E::Int) -> Self::Word;
    /// Of a truth value.
    fn of_mask(&self, value: E::Mask) -> Self::Word;
}

/// The word of a value of this class.
macro_rules! word {
    ($registers:ident real $value:expr) => {
        $registers.of_real($value)
    };
    ($registers:ident int $value:expr) => {
        $registers.of_int($value)
    };
    ($registers:ident mask $value:expr) => {
        $registers.of_mask($value)
    };
}

macro_rules! define {
    (
        operators { $($operator:ident $operator_name:literal $both:ident $trait:ident::$call:ident
            [$($operator_flag:ident)?];)+ }
        methods { $($method:ident $method_name:literal $of:ident.$calls:ident($($operand:ident: $its:ident),*)
            -> $out:ident [$($method_flag:ident)?];)+ }
        shifts { $($shift:ident $shift_calls:ident;)+ }
        words { $($word:ident $word_name:literal ($($on:ident),+) [$($word_flag:ident)?];)+ }
        functions { $($function:ident $function_calls:ident($($second:ident)?);)+ }
    ) => {
        /// The word an operation yields, its operands being in `registers`.
        #[inline]
        pub fn apply<E: Emit, R: Registers<E>>(op: Op, emit: E, registers: &R) -> R::Word {
            match op {
                Op::Load(source) => registers.load(source),
                Op::Constant(bits) => registers.constant(bits),
                Op::Number(number) => registers.of_real(emit.real(number.value())),
                Op::Integer(value) => registers.of_int(emit.int(value)),
                Op::Truth(value) => registers.of_mask(emit.mask(value)),
                Op::Table(table, index) => registers.of_real(emit.table(table, registers.int(index))),
                $(Op::$operator(a, b) => {
                    word!(registers $both $trait::$call(registers.$both(a), registers.$both(b)))
                })+
                $(Op::$method(a $(, $operand)*) => {
                    word!(registers $out registers.$of(a).$calls($(registers.$its($operand)),*))
                })+
                $(Op::$shift(a, bits) => registers.of_int(registers.int(a).$shift_calls(bits & 31)),)+
                Op::And(a, b) => match registers.class(a) {
                    Class::Mask => registers.of_mask(registers.mask(a) & registers.mask(b)),
                    _ => registers.of_int(registers.int(a) & registers.int(b)),
                },
                Op::Or(a, b) => match registers.class(a) {
                    Class::Mask => registers.of_mask(registers.mask(a) | registers.mask(b)),
                    _ => registers.of_int(registers.int(a) | registers.int(b)),
                },
                Op::Xor(a, b) => match registers.class(a) {
                    Class::Mask => registers.of_mask(registers.mask(a) ^ registers.mask(b)),
                    _ => registers.of_int(registers.int(a) ^ registers.int(b)),
                },
                Op::Not(a) => match registers.class(a) {
                    Class::Mask => registers.of_mask(!registers.mask(a)),
                    _ => registers.of_int(registers.int(a) ^ emit.int(-1)),
                },
                Op::Select(mask, a, b) => {
                    let mask = registers.mask(mask);
                    match registers.class(a) {
                        Class::Real => registers.of_real(mask.select(registers.real(a), registers.real(b))),
                        Class::Int => registers.of_int(mask.select(registers.int(a), registers.int(b))),
                        Class::Mask => registers.of_mask(mask.select(registers.mask(a), registers.mask(b))),
                    }
                }
                $(Op::$function(a $(, $second)?) => {
                    registers.of_real(registers.real(a).$function_calls($(registers.real($second))?))
                })+
            }
        }
    };
}
operations! {define}
