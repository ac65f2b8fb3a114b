use crate::emit::{Color, Emit, Mask, Real};
use crate::nodes::{BLACK, NOT_NEGATIVE, WHITE};

node! {
    /// Linear mix `a + (b - a) weight`, per channel with alpha. At weight 0 `b` is not evaluated, at
    /// weight 1 `a` is not, and the other passes unchanged to the bit.
    mix in color,
    source "mental ray base shaders, mib_color_mix",
    inputs {
        /// Share of `b`; outside 0..1 it extrapolates.
        weight: scalar = 0.5, in 0.0..=1.0;
        /// Colour at weight 0.
        a: color = BLACK, in NOT_NEGATIVE, when a_shows;
        /// Colour at weight 1.
        b: color = WHITE, in NOT_NEGATIVE, when b_shows;
    }
    outputs {
        /// The mixed colour.
        color: color, in NOT_NEGATIVE;
    }
}

#[inline(always)]
fn a_shows<E: Emit>(e: E, i: &Inputs<E>) -> E::Mask {
    i.weight.not_equal(e.real(1.0))
}

#[inline(always)]
fn b_shows<E: Emit>(e: E, i: &Inputs<E>) -> E::Mask {
    i.weight.not_equal(e.real(0.0))
}

#[inline(always)]
fn channel<R: Real>(a: R, b: R, weight: R) -> R {
    // a (1 - w) + b w: exact at both ends, and no overflow of b - a.
    b.mul_add(weight, a * (weight.same(1.0) - weight))
}

#[inline(always)]
fn body<E: Emit>(e: E, i: &Inputs<E>) -> Outputs<E> {
    let (a, b, w) = (i.a, i.b, i.weight);
    let mixed = Color {
        r: channel(a.r, b.r, w),
        g: channel(a.g, b.g, w),
        b: channel(a.b, b.b, w),
        a: channel(a.a, b.a, w),
    };
    let without_a = a_shows(e, i).select(mixed, b);
    Outputs { color: b_shows(e, i).select(without_a, a) }
}
