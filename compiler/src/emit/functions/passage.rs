//! From one value to another, or to nothing.

use super::conventions::clamp_finite;
use crate::emit::{Components, Mask, Real};

/// `a (1 - weight) + b weight` in every component, alpha too. At weight 0 and 1 the other side leaves no
/// trace.
#[inline(always)]
pub fn mixed<R: Real, T: Components<R>>(a: T, b: T, weight: R) -> T {
    let (from, to) = (a.to_words(), b.to_words());
    let (zero, one) = (weight.same(0.0), weight.same(1.0));
    let rest = one - weight;
    let mut mixed = from;
    for k in 0..4 {
        // Exact at both ends, and no overflow of b - a.
        mixed[k] = to[k].mul_add(weight, from[k] * rest);
    }
    let with_a = weight.not_equal(one).select(T::from_words(mixed), b);
    weight.not_equal(zero).select(with_a, a)
}

/// A share of a value in every component, alpha too; 0, without a trace of the value, where it does not show.
#[inline(always)]
pub fn cut<R: Real, T: Components<R>>(value: T, share: R, shows: R::Mask) -> T {
    let zero = share.same(0.0);
    let mut words = value.to_words();
    for word in &mut words {
        *word = clamp_finite(*word * share);
    }
    shows.select(T::from_words(words), T::from_words([zero; 4]))
}
