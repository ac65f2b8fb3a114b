//! The back end of eight points in plain Rust, lane by lane as [`Scalar`](crate::emit::scalar::Scalar).
//!
//! Only [`block`](super::block) runs on it: bodies are not compiled for it.

use std::array::from_fn;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use crate::emit::scalar::{Bool, F32, I32};
use crate::emit::{Emit, Int, Mask, Real, Select, Table};
use crate::storage::LANES;

/// The back end.
#[derive(Clone, Copy, Debug)]
pub struct Eights;

/// A value of each lane.
#[derive(Clone, Copy, Debug)]
pub struct Eight<T>(pub [T; LANES]);

impl Emit for Eights {
    type Real = Eight<F32>;
    type Int = Eight<I32>;
    type Mask = Eight<Bool>;
    fn real(self, value: f64) -> Eight<F32> {
        Eight([F32(value as f32); LANES])
    }
    fn int(self, value: i32) -> Eight<I32> {
        Eight([I32(value); LANES])
    }
    fn mask(self, value: bool) -> Eight<Bool> {
        Eight([Bool(value); LANES])
    }
    fn table(self, table: Table, index: Eight<I32>) -> Eight<F32> {
        Eight(index.0.map(|index| F32(table.at(index.0))))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),+) => {$(
        impl<T: $trait<Output = T> + Copy> $trait for Eight<T> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(from_fn(|lane| self.0[lane].$method(other.0[lane])))
            }
        }
    )+};
}
operators!(Add add, Sub sub, Mul mul, Div div, BitAnd bitand, BitOr bitor, BitXor bitxor);

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl $trait<f64> for Eight<F32> {
            type Output = Self;
            fn $method(self, constant: f64) -> Self {
                self.$method(self.same(constant))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Eight<F32> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|number| -number))
    }
}

impl Not for Eight<Bool> {
    type Output = Self;
    fn not(self) -> Self {
        Self(self.0.map(|truth| !truth))
    }
}

impl<T: Select<Bool> + Copy> Select<Eight<Bool>> for Eight<T> {
    fn select(mask: Eight<Bool>, if_true: Self, if_false: Self) -> Self {
        Self(from_fn(|lane| T::select(mask.0[lane], if_true.0[lane], if_false.0[lane])))
    }
}

/// The type of a class.
macro_rules! of {
    (real) => { Eight<F32> };
    (int) => { Eight<I32> };
    (mask) => { Eight<Bool> };
}

/// One method of a trait: those of the other class, and operators of `std::ops`, are left out.
macro_rules! method {
    (real of real neg $($rest:tt)*) => {};
    (real of int $($rest:tt)*) => {};
    (int of real $($rest:tt)*) => {};
    ($class:ident of $same:ident $calls:ident ($($operand:ident: $its:ident),*) -> $out:ident) => {
        fn $calls(self $(, $operand: of!($its))*) -> of!($out) {
            Eight(from_fn(|lane| self.0[lane].$calls($($operand.0[lane]),*)))
        }
    };
}

macro_rules! define {
    (
        operators $operators:tt
        methods { $($method:ident $method_name:literal $of:ident.$calls:ident $operands:tt
            -> $out:ident [$($method_flag:ident)?];)+ }
        shifts { $($shift:ident $shift_calls:ident;)+ }
        words $words:tt
        functions { $($function:ident $function_calls:ident($($second:ident)?);)+ }
    ) => {
        impl Real for Eight<F32> {
            type Mask = Eight<Bool>;
            type Int = Eight<I32>;
            fn same(self, value: f64) -> Self {
                Eights.real(value)
            }
            $(method! { real of $of $calls $operands -> $out })+
            $(#[inline(never)]
            fn $function_calls(self $(, $second: Self)?) -> Self {
                Self(from_fn(|lane| self.0[lane].$function_calls($($second.0[lane])?)))
            })+
        }

        impl Int for Eight<I32> {
            type Mask = Eight<Bool>;
            type Real = Eight<F32>;
            fn same(self, value: i32) -> Self {
                Eights.int(value)
            }
            $(fn $shift_calls(self, bits: u32) -> Self {
                Self(self.0.map(|integer| integer.$shift_calls(bits)))
            })+
            $(method! { int of $of $calls $operands -> $out })+
        }
    };
}
crate::operations! {define}

impl Mask for Eight<Bool> {}
