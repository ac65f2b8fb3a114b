//! One point at a time, over `f32`: the tree walk. Its types are those of the portable forms too.

use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

use super::methods::standard_functions;
use super::{Bits, Emit, Int, Mask, Real, Select, Sink, Table, Words};

/// The back end of one `f32` point.
#[derive(Clone, Copy, Debug)]
pub struct Scalar;

/// A number.
#[derive(Clone, Copy, Debug)]
pub struct F32(pub f32);
/// An integer.
#[derive(Clone, Copy, Debug)]
pub struct I32(pub i32);
/// A truth value.
#[derive(Clone, Copy, Debug)]
pub struct Bool(pub bool);

impl Emit for Scalar {
    type Real = F32;
    type Int = I32;
    type Mask = Bool;
    #[inline(always)]
    fn real(self, value: f64) -> F32 {
        F32(value as f32)
    }
    #[inline(always)]
    fn int(self, value: i32) -> I32 {
        I32(value)
    }
    #[inline(always)]
    fn mask(self, value: bool) -> Bool {
        Bool(value)
    }
    #[inline(always)]
    fn table(self, table: Table, index: I32) -> F32 {
        F32(table.at(index.0))
    }
}

macro_rules! operator {
    ($type:ident, $trait:ident $method:ident, |$a:ident, $b:ident| $value:expr) => {
        impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self.0, other.0);
                Self($value)
            }
        }
    };
}
operator!(F32, Add add, |a, b| a + b);
operator!(F32, Sub sub, |a, b| a - b);
operator!(F32, Mul mul, |a, b| a * b);
operator!(F32, Div div, |a, b| a / b);
operator!(I32, Add add, |a, b| a.wrapping_add(b));
operator!(I32, Sub sub, |a, b| a.wrapping_sub(b));
operator!(I32, Mul mul, |a, b| a.wrapping_mul(b));
operator!(I32, BitAnd bitand, |a, b| a & b);
operator!(I32, BitOr bitor, |a, b| a | b);
operator!(I32, BitXor bitxor, |a, b| a ^ b);
operator!(Bool, BitAnd bitand, |a, b| a & b);
operator!(Bool, BitOr bitor, |a, b| a | b);
operator!(Bool, BitXor bitxor, |a, b| a ^ b);

macro_rules! with_constant {
    ($($trait:ident $method:ident),+) => {$(
        impl $trait<f64> for F32 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, constant: f64) -> Self {
                self.$method(F32(constant as f32))
            }
        }
    )+};
}
with_constant!(Add add, Sub sub, Mul mul, Div div);

impl Neg for F32 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Not for Bool {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

macro_rules! select {
    ($($type:ident),+) => {$(
        impl Select<Bool> for $type {
            #[inline(always)]
            fn select(mask: Bool, if_true: Self, if_false: Self) -> Self {
                if mask.0 { if_true } else { if_false }
            }
        }
    )+};
}
select!(F32, I32, Bool);

impl Real for F32 {
    type Mask = Bool;
    type Int = I32;
    #[inline(always)]
    fn same(self, value: f64) -> Self {
        Self(value as f32)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(always)]
    fn minimum(self, other: Self) -> Self {
        if self.0 < other.0 { self } else { other }
    }
    #[inline(always)]
    fn maximum(self, other: Self) -> Self {
        if self.0 > other.0 { self } else { other }
    }
    #[inline(always)]
    fn absolute(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Self(self.0.floor())
    }
    #[inline(always)]
    fn ceil(self) -> Self {
        Self(self.0.ceil())
    }
    #[inline(always)]
    fn truncate(self) -> Self {
        Self(self.0.trunc())
    }
    #[inline(always)]
    fn round_even(self) -> Self {
        Self(self.0.round_ties_even())
    }
    #[inline(always)]
    fn less(self, other: Self) -> Bool {
        Bool(self.0 < other.0)
    }
    #[inline(always)]
    fn less_equal(self, other: Self) -> Bool {
        Bool(self.0 <= other.0)
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Bool {
        Bool(self.0 == other.0)
    }
    #[inline(always)]
    fn not_equal(self, other: Self) -> Bool {
        Bool(self.0 != other.0)
    }
    #[inline(always)]
    fn to_int(self) -> I32 {
        I32(self.0 as i32)
    }
    standard_functions!();
}

impl Bits for F32 {
    #[inline(always)]
    fn to_bits(self) -> I32 {
        I32(self.0.to_bits() as i32)
    }
    #[inline(always)]
    fn from_bits(bits: I32) -> Self {
        Self(f32::from_bits(bits.0 as u32))
    }
}

impl Int for I32 {
    type Mask = Bool;
    type Real = F32;
    #[inline(always)]
    fn same(self, value: i32) -> Self {
        Self(value)
    }
    #[inline(always)]
    fn shift_left(self, bits: u32) -> Self {
        Self(self.0 << bits)
    }
    #[inline(always)]
    fn shift_right(self, bits: u32) -> Self {
        Self((self.0 as u32 >> bits) as i32)
    }
    #[inline(always)]
    fn shift_right_signed(self, bits: u32) -> Self {
        Self(self.0 >> bits)
    }
    #[inline(always)]
    fn equal(self, other: Self) -> Bool {
        Bool(self.0 == other.0)
    }
    #[inline(always)]
    fn less(self, other: Self) -> Bool {
        Bool(self.0 < other.0)
    }
    #[inline(always)]
    fn to_real(self) -> F32 {
        F32(self.0 as f32)
    }
}

impl Mask for Bool {}

impl Words<Scalar> for &[u32] {
    #[inline(always)]
    fn real(&self, index: usize) -> F32 {
        F32(f32::from_bits(self[index]))
    }
    #[inline(always)]
    fn int(&self, index: usize) -> I32 {
        I32(self[index] as i32)
    }
    #[inline(always)]
    fn mask(&self, index: usize) -> Bool {
        Bool(self[index] != 0)
    }
    #[inline(always)]
    fn fixed(&self, index: usize) -> i32 {
        self[index] as i32
    }
}

impl Sink<Scalar> for &mut [u32] {
    #[inline(always)]
    fn real(&mut self, index: usize, value: F32) {
        self[index] = value.0.to_bits();
    }
    #[inline(always)]
    fn int(&mut self, index: usize, value: I32) {
        self[index] = value.0 as u32;
    }
    #[inline(always)]
    fn mask(&mut self, index: usize, value: Bool) {
        self[index] = if value.0 { u32::MAX } else { 0 };
    }
}
