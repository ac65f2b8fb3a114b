//! What a back end offers.

use super::Table;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

/// A back end: makes constants, from which [`Real`], [`Int`] and [`Mask`] values are computed.
pub trait Emit: Copy {
    /// 32-bit IEEE 754 numbers (64-bit in the reference back end), one or several lanes.
    type Real: Real<Mask = Self::Mask, Int = Self::Int>;
    /// 32-bit two's complement integers that wrap.
    type Int: Int<Mask = Self::Mask, Real = Self::Real>;
    /// Truth per lane.
    type Mask: Mask;
    /// The constant `value`, rounded to the precision of [`Emit::Real`].
    fn real(self, value: f64) -> Self::Real;
    /// The constant `value`.
    fn int(self, value: i32) -> Self::Int;
    /// The constant `value`.
    fn mask(self, value: bool) -> Self::Mask;
    /// The number of a table at a position; outside the table that of its nearer end.
    fn table(self, table: Table, index: Self::Int) -> Self::Real;
}

/// Chosen lane by lane; see [`Mask::select`].
pub trait Select<M>: Sized {
    /// `if mask { if_true } else { if_false }`, bits untouched.
    fn select(mask: M, if_true: Self, if_false: Self) -> Self;
}

/// Floating point. `+ - * /` and [`Real::sqrt`] round to nearest, ties to even; nothing is
/// contracted, reassociated or flushed to zero. The `f64` forms take a constant.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + Select<<Self as Real>::Mask>
{
    /// Result of comparisons.
    type Mask: Mask;
    /// Integers of the same lanes.
    type Int: Int<Mask = Self::Mask, Real = Self>;
    /// The constant `value` in the lanes of `self`.
    fn same(self, value: f64) -> Self;
    /// `self * factor + addend`, rounded once.
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// `if self < other { self } else { other }`: the other where either is NaN.
    fn minimum(self, other: Self) -> Self;
    /// `if self > other { self } else { other }`: the other where either is NaN.
    fn maximum(self, other: Self) -> Self;
    /// Sign bit cleared.
    fn absolute(self) -> Self;
    /// Square root; NaN below zero, -0 for -0.
    fn sqrt(self) -> Self;
    /// Largest integer not above.
    fn floor(self) -> Self;
    /// Smallest integer not below.
    fn ceil(self) -> Self;
    /// Integer part, towards zero.
    fn truncate(self) -> Self;
    /// Nearest integer, ties to even.
    fn round_even(self) -> Self;
    /// `self < other`; false where either is NaN.
    fn less(self, other: Self) -> Self::Mask;
    /// `self <= other`; false where either is NaN.
    fn less_equal(self, other: Self) -> Self::Mask;
    /// `self == other`; false where either is NaN; -0 equals 0.
    fn equal(self, other: Self) -> Self::Mask;
    /// `!(self == other)`; true where either is NaN.
    fn not_equal(self, other: Self) -> Self::Mask;
    /// As Rust's `as i32`: towards zero, NaN gives 0, outside the range its nearest end.
    fn to_int(self) -> Self::Int;

    /// Sine of an angle in radians. This and the functions below are accurate to the tier: see
    /// [`standard`](super::standard).
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// Tangent of an angle in radians.
    fn tan(self) -> Self;
    /// Arc sine; NaN outside -1..=1.
    fn asin(self) -> Self;
    /// Arc cosine; NaN outside -1..=1.
    fn acos(self) -> Self;
    /// Arc tangent.
    fn atan(self) -> Self;
    /// The angle of the point (`x`, `self`), in -pi..=pi, with the signs of zeros counting as in
    /// IEEE 754.
    fn atan2(self, x: Self) -> Self;
    /// `e^self`.
    fn exp(self) -> Self;
    /// `2^self`.
    fn exp2(self) -> Self;
    /// `e^self - 1`, accurate near 0.
    fn expm1(self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Natural logarithm: -inf at 0, NaN below.
    fn ln(self) -> Self;
    /// Logarithm to base 2: -inf at 0, NaN below.
    fn log2(self) -> Self;
    /// `ln(1 + self)`, accurate near 0: -inf at -1, NaN below.
    fn log1p(self) -> Self;
    /// `self^exponent` as in IEEE 754: 1 for an exponent of 0 and a base of 1, NaN for a negative
    /// finite base and an exponent that is not whole, infinite for zero to a negative power, with
    /// the sign of the base for an odd whole exponent.
    fn pow(self, exponent: Self) -> Self;

    /// `self > other`; false where either is NaN.
    #[inline(always)]
    fn greater(self, other: Self) -> Self::Mask {
        other.less(self)
    }
    /// `self >= other`; false where either is NaN.
    #[inline(always)]
    fn greater_equal(self, other: Self) -> Self::Mask {
        other.less_equal(self)
    }
    /// `low.maximum(self)` then `.minimum(high)` so that NaN becomes `low`: always in
    /// `low..=high` when `low <= high`.
    #[inline(always)]
    fn clamp_to(self, low: Self, high: Self) -> Self {
        self.maximum(low).minimum(high)
    }
    /// Clamped to 0..=1; NaN becomes 0.
    #[inline(always)]
    fn saturate(self) -> Self {
        self.clamp_to(self.same(0.0), self.same(1.0))
    }
    /// `self / divisor`, and 0 where the divisor is zero.
    #[inline(always)]
    fn divide_or_zero(self, divisor: Self) -> Self {
        let zero = self.same(0.0);
        divisor.equal(zero).select(zero, self / divisor)
    }
}

/// 32-bit integers that wrap.
pub trait Int:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
    + Select<<Self as Int>::Mask>
{
    /// Result of comparisons.
    type Mask: Mask;
    /// Numbers of the same lanes.
    type Real: Real<Mask = Self::Mask, Int = Self>;
    /// The constant `value` in the lanes of `self`.
    fn same(self, value: i32) -> Self;
    /// Shift left by a constant below 32.
    fn shift_left(self, bits: u32) -> Self;
    /// Logical shift right by a constant below 32.
    fn shift_right(self, bits: u32) -> Self;
    /// Arithmetic shift right by a constant below 32.
    fn shift_right_signed(self, bits: u32) -> Self;
    /// `self == other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `self < other`, signed.
    fn less(self, other: Self) -> Self::Mask;
    /// Nearest number, ties to even.
    fn to_real(self) -> Self::Real;
}

/// Numbers of 32 bits, whose bits are integers of the same lanes. Back ends that have them can expand
/// the functions of [`Real`] as the [`standard`](super::standard) tier does.
pub trait Bits: Real {
    /// The bits as an integer.
    fn to_bits(self) -> Self::Int;
    /// The number with these bits.
    fn from_bits(bits: Self::Int) -> Self;
}

/// Truth per lane.
pub trait Mask:
    Copy
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
    + Not<Output = Self>
    + Select<Self>
{
    /// `if self { if_true } else { if_false }` per lane, bits untouched: a NaN in the side not
    /// chosen leaves no trace.
    #[inline(always)]
    fn select<T: Select<Self>>(self, if_true: T, if_false: T) -> T {
        T::select(self, if_true, if_false)
    }
}
