use std::ops::{Add, Mul};

use glam::{Vec3, Vec4};
use phenomenon_compiler::emit::functions::conventions::pow_or_zero;
use phenomenon_compiler::emit::functions::passage::mixed;
use phenomenon_compiler::emit::functions::shaping::passage;
use phenomenon_compiler::emit::scalar::F32;
use phenomenon_compiler::emit::{One, Real};

use super::kinds::{SameBits, Std, vec3, vector};

/// A number, or several side by side.
pub trait Value: Copy + Add<Output = Self> + Mul<f32, Output = Self> {
    /// A function of two numbers for each component.
    fn each(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self;
}

impl Value for f32 {
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self {
        of(self, other)
    }
}

impl Value for Vec3 {
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self {
        Self::new(of(self.x, other.x), of(self.y, other.y), of(self.z, other.z))
    }
}

impl Value for Vec4 {
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(f32, f32) -> f32) -> Self {
        let [x, y, z, w] = self.to_array();
        let [a, b, c, d] = other.to_array();
        Self::new(of(x, a), of(y, b), of(z, c), of(w, d))
    }
}

/// Numbers and vectors.
pub trait Numbers {
    /// Scalar product.
    fn dot(a: Vec3, b: Vec3) -> f32;
    /// Vector product.
    fn cross(a: Vec3, b: Vec3) -> Vec3;
    /// A vector at unit length; zero stays zero.
    fn normalised(vector: Vec3) -> Vec3;
    /// Length of a vector.
    fn length(vector: Vec3) -> f32;
    /// `a (1 - weight) + b weight`: `a` at weight 0, `b` at weight 1.
    fn mix<V: Value>(a: V, b: V, weight: f32) -> V;
    /// A power of a number that is not negative.
    fn power(base: f32, exponent: f32) -> f32;
    /// A power of each component.
    #[inline(always)]
    fn powers(base: Vec3, exponent: f32) -> Vec3 {
        Vec3::new(
            Self::power(base.x, exponent),
            Self::power(base.y, exponent),
            Self::power(base.z, exponent),
        )
    }
    /// Where `x` lies between two bounds, 0 to 1, the second of which may be the smaller; of equal bounds 0
    /// below and 1 from there on.
    fn between(x: f32, low: f32, high: f32) -> f32;
    /// The same without corners.
    fn smooth_step(x: f32, low: f32, high: f32) -> f32;
    /// How much of a whole a value is, at most 1; of nothing, anything is all.
    #[inline(always)]
    fn share(value: f32, whole: f32) -> f32 {
        if whole == 0.0 {
            return if value > 0.0 { 1.0 } else { 0.0 };
        }
        (value / whole).clamp(0.0, 1.0)
    }
}

impl Numbers for Std {
    #[inline]
    fn dot(a: Vec3, b: Vec3) -> f32 {
        a.dot(b)
    }
    #[inline]
    fn cross(a: Vec3, b: Vec3) -> Vec3 {
        a.cross(b)
    }
    #[inline]
    fn normalised(vector: Vec3) -> Vec3 {
        vector.normalize_or_zero()
    }
    #[inline]
    fn length(vector: Vec3) -> f32 {
        vector.length()
    }
    #[inline]
    fn mix<V: Value>(a: V, b: V, weight: f32) -> V {
        a * (1.0 - weight) + b * weight
    }
    #[inline]
    fn power(base: f32, exponent: f32) -> f32 {
        base.powf(exponent)
    }
    #[inline]
    fn between(x: f32, low: f32, high: f32) -> f32 {
        if low == high {
            return if x < low { 0.0 } else { 1.0 };
        }
        ((x - low) / (high - low)).clamp(0.0, 1.0)
    }
    #[inline]
    fn smooth_step(x: f32, low: f32, high: f32) -> f32 {
        let t = Self::between(x, low, high);
        t * t * (3.0 - 2.0 * t)
    }
}

impl Numbers for SameBits {
    #[inline(always)]
    fn dot(a: Vec3, b: Vec3) -> f32 {
        vector(a).dot(vector(b)).0
    }
    #[inline(always)]
    fn cross(a: Vec3, b: Vec3) -> Vec3 {
        vec3(vector(a).cross(vector(b)))
    }
    #[inline(always)]
    fn normalised(of: Vec3) -> Vec3 {
        vec3(vector(of).normalized())
    }
    #[inline(always)]
    fn length(of: Vec3) -> f32 {
        vector(of).length().0
    }
    #[inline(always)]
    fn mix<V: Value>(a: V, b: V, weight: f32) -> V {
        a.each(b, |a, b| mixed(One { x: F32(a) }, One { x: F32(b) }, F32(weight)).x.0)
    }
    #[inline(always)]
    fn power(base: f32, exponent: f32) -> f32 {
        pow_or_zero(F32(base), F32(exponent)).0
    }
    #[inline(always)]
    fn between(x: f32, low: f32, high: f32) -> f32 {
        passage(F32(x), F32(low), F32(high)).0
    }
    #[inline(always)]
    fn smooth_step(x: f32, low: f32, high: f32) -> f32 {
        let t = passage(F32(x), F32(low), F32(high));
        (t * t * t.mul_add(F32(-2.0), F32(3.0))).0
    }
}
