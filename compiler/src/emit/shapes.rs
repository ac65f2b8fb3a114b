//! Vectors and colours over any back end's numbers, and the shapes a generic node works on.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Real, Select};

/// A single number where a generic node may also work on vectors and colours.
#[derive(Clone, Copy, Debug)]
pub struct One<R> {
    /// The number.
    pub x: R,
}

/// Three numbers: a point, direction or normal.
#[derive(Clone, Copy, Debug)]
pub struct Vector<R> {
    /// First component.
    pub x: R,
    /// Second component.
    pub y: R,
    /// Third component.
    pub z: R,
}

/// Scene-linear Rec. 709 colour with alpha. Arithmetic acts on r, g and b; the result has the
/// alpha of the left operand, so that adding light to an opaque surface leaves it opaque.
#[derive(Clone, Copy, Debug)]
pub struct Color<R> {
    /// Red.
    pub r: R,
    /// Green.
    pub g: R,
    /// Blue.
    pub b: R,
    /// Alpha: 1 is opaque.
    pub a: R,
}

/// An affine map of points written as rows: `p.x x + p.y y + p.z z + translation`.
#[derive(Clone, Copy, Debug)]
pub struct Transform<R> {
    /// Where the first axis goes.
    pub x: Vector<R>,
    /// Where the second axis goes.
    pub y: Vector<R>,
    /// Where the third axis goes.
    pub z: Vector<R>,
    /// Where the origin goes.
    pub translation: Vector<R>,
}

/// What a generic node (add, multiply, clamp …) may do with its operands, component by component.
pub trait Components<R: Real>:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<R, Output = Self>
    + Select<R::Mask>
{
    /// Words it occupies.
    const WIDTH: usize;
    /// The first `WIDTH` of four words.
    fn from_words(words: [R; 4]) -> Self;
    /// As four words, those past `WIDTH` repeating the last.
    fn to_words(self) -> [R; 4];
    /// [`Real::minimum`] per component.
    fn minimum(self, other: Self) -> Self;
    /// [`Real::maximum`] per component.
    fn maximum(self, other: Self) -> Self;
    /// [`Real::absolute`] per component.
    fn absolute(self) -> Self;
    /// [`Real::divide_or_zero`] per component.
    fn divide_or_zero(self, other: Self) -> Self;
    /// [`Real::floor`] per component.
    fn floor(self) -> Self;
    /// `addend + self * (factor)` rounded once, per component.
    fn mul_add(self, factor: R, addend: Self) -> Self;
}

macro_rules! componentwise {
    ($name:ident { $($field:ident),+ } keep { $($kept:ident),* } width $width:literal, words |$w:ident| $from:expr, |$me:ident| $to:expr) => {
        componentwise!(@binary $name, Add add, [$($field)+], [$($kept)*]);
        componentwise!(@binary $name, Sub sub, [$($field)+], [$($kept)*]);
        componentwise!(@binary $name, Mul mul, [$($field)+], [$($kept)*]);
        componentwise!(@binary $name, Div div, [$($field)+], [$($kept)*]);
        impl<R: Real> Mul<R> for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: R) -> Self {
                Self { $($field: self.$field * factor,)+ $($kept: self.$kept,)* }
            }
        }
        impl<R: Real> Neg for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self { $($field: -self.$field,)+ $($kept: self.$kept,)* }
            }
        }
        impl<M: Copy, R: Select<M>> Select<M> for $name<R> {
            #[inline(always)]
            fn select(mask: M, if_true: Self, if_false: Self) -> Self {
                Self {
                    $($field: R::select(mask, if_true.$field, if_false.$field),)+
                    $($kept: R::select(mask, if_true.$kept, if_false.$kept),)*
                }
            }
        }
        impl<R: Real> Components<R> for $name<R> {
            const WIDTH: usize = $width;
            #[inline(always)]
            fn from_words($w: [R; 4]) -> Self { $from }
            #[inline(always)]
            fn to_words(self) -> [R; 4] { let $me = self; $to }
            #[inline(always)]
            fn minimum(self, other: Self) -> Self {
                Self { $($field: self.$field.minimum(other.$field),)+ $($kept: self.$kept,)* }
            }
            #[inline(always)]
            fn maximum(self, other: Self) -> Self {
                Self { $($field: self.$field.maximum(other.$field),)+ $($kept: self.$kept,)* }
            }
            #[inline(always)]
            fn absolute(self) -> Self {
                Self { $($field: self.$field.absolute(),)+ $($kept: self.$kept,)* }
            }
            #[inline(always)]
            fn divide_or_zero(self, other: Self) -> Self {
                Self { $($field: self.$field.divide_or_zero(other.$field),)+ $($kept: self.$kept,)* }
            }
            #[inline(always)]
            fn floor(self) -> Self {
                Self { $($field: self.$field.floor(),)+ $($kept: self.$kept,)* }
            }
            #[inline(always)]
            fn mul_add(self, factor: R, addend: Self) -> Self {
                Self { $($field: self.$field.mul_add(factor, addend.$field),)+ $($kept: addend.$kept,)* }
            }
        }
    };
    (@binary $name:ident, $trait:ident $method:ident, [$($field:ident)+], $kept:tt) => {
        componentwise!(@binary2 $name, $trait $method, [$($field)+], $kept);
    };
    (@binary2 $name:ident, $trait:ident $method:ident, [$($field:ident)+], [$($kept:ident)*]) => {
        impl<R: Real> $trait for $name<R> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self { $($field: self.$field.$method(other.$field),)+ $($kept: self.$kept,)* }
            }
        }
    };
}

componentwise!(One { x } keep {} width 1, words |w| One { x: w[0] }, |v| [v.x, v.x, v.x, v.x]);
componentwise!(Vector { x, y, z } keep {} width 3,
    words |w| Vector { x: w[0], y: w[1], z: w[2] }, |v| [v.x, v.y, v.z, v.z]);
componentwise!(Color { r, g, b } keep { a } width 4,
    words |w| Color { r: w[0], g: w[1], b: w[2], a: w[3] }, |v| [v.r, v.g, v.b, v.a]);

impl<R: Real> Vector<R> {
    /// `fma(x, x', fma(y, y', z z'))`: the order of operations is part of the definition.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x.mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }

    /// Cross product, each component `fma(a, b, -(c d))`.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y.mul_add(other.z, -(self.z * other.y)),
            y: self.z.mul_add(other.x, -(self.x * other.z)),
            z: self.x.mul_add(other.y, -(self.y * other.x)),
        }
    }

    /// Largest absolute component.
    #[inline(always)]
    pub fn largest(self) -> R {
        self.x.absolute().maximum(self.y.absolute()).maximum(self.z.absolute())
    }

    /// Euclidean length; scaled first, so that neither tiny nor huge vectors overflow.
    #[inline(always)]
    pub fn length(self) -> R {
        let scale = self.largest();
        let unit = self.divided_by(scale);
        unit.dot(unit).sqrt() * scale
    }

    /// Unit vector; the zero vector, and one with NaN, stays zero.
    #[inline(always)]
    pub fn normalized(self) -> Self {
        let unit = self.divided_by(self.largest());
        unit.divided_by(unit.dot(unit).sqrt())
    }

    /// Divided by a number, and 0 where it is not above zero (or NaN).
    #[inline(always)]
    pub fn divided_by(self, divisor: R) -> Self {
        let zero = divisor.same(0.0);
        let inside = super::Mask::select(divisor.greater(zero), divisor, divisor.same(1.0));
        let quotient = Self { x: self.x / inside, y: self.y / inside, z: self.z / inside };
        let none = Self { x: zero, y: zero, z: zero };
        super::Mask::select(divisor.greater(zero), quotient, none)
    }
}

impl<M: Copy, R: Select<M>> Select<M> for Transform<R> {
    #[inline(always)]
    fn select(mask: M, if_true: Self, if_false: Self) -> Self {
        Self {
            x: Vector::select(mask, if_true.x, if_false.x),
            y: Vector::select(mask, if_true.y, if_false.y),
            z: Vector::select(mask, if_true.z, if_false.z),
            translation: Vector::select(mask, if_true.translation, if_false.translation),
        }
    }
}

impl<R: Real> Transform<R> {
    /// Where a point goes: `fma(p.x, x, fma(p.y, y, fma(p.z, z, translation)))`.
    #[inline(always)]
    pub fn point(self, point: Vector<R>) -> Vector<R> {
        let third = self.z.mul_add(point.z, self.translation);
        self.x.mul_add(point.x, self.y.mul_add(point.y, third))
    }

    /// Where a vector goes, which the translation leaves alone: `fma(v.x, x, fma(v.y, y, v.z z))`.
    #[inline(always)]
    pub fn vector(self, vector: Vector<R>) -> Vector<R> {
        self.x.mul_add(vector.x, self.y.mul_add(vector.y, self.z * vector.z))
    }

    /// Where a normal points, at unit length: by the cofactors, which stand for the inverse transposed
    /// without dividing by the determinant; only its sign is needed. The rows are scaled first, so that
    /// cofactors of tiny and huge maps neither vanish nor overflow.
    #[inline(always)]
    pub fn normal(self, normal: Vector<R>) -> Vector<R> {
        let largest = self.x.largest().maximum(self.y.largest()).maximum(self.z.largest());
        let (x, y, z) =
            (self.x.divided_by(largest), self.y.divided_by(largest), self.z.divided_by(largest));
        let (of_x, of_y, of_z) = (y.cross(z), z.cross(x), x.cross(y));
        let mirrors = x.dot(of_x).less(normal.x.same(0.0));
        let turned = of_x.mul_add(normal.x, of_y.mul_add(normal.y, of_z * normal.z));
        super::Mask::select(mirrors, -turned, turned).normalized()
    }
}
