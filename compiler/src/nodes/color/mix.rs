use crate::emit::{Components, Emit, Mask, Real};

node! {
    /// Linear mix `a (1 - weight) + b weight`, per component and, for colours, alpha. At weight 0 `b`
    /// is not evaluated, at weight 1 `a` is not, and the other passes unchanged to the bit.
    mix in color generic,
    source "mental ray base shaders, mib_color_mix",
    inputs {
        /// Share of `b`; outside 0..1 it extrapolates.
        weight: scalar = 0.5, in 0.0..=1.0;
        /// Value at weight 0.
        a: generic = 0.0, when a_shows;
        /// Value at weight 1.
        b: generic = 1.0, when b_shows;
    }
    outputs {
        /// The mixture.
        result: generic;
    }
}

#[inline(always)]
fn a_shows<E: Emit, T: Components<E::Real>>(e: E, i: &Inputs<E, T>) -> E::Mask {
    i.weight.not_equal(e.real(1.0))
}

#[inline(always)]
fn b_shows<E: Emit, T: Components<E::Real>>(e: E, i: &Inputs<E, T>) -> E::Mask {
    i.weight.not_equal(e.real(0.0))
}

#[inline(always)]
fn body<E: Emit, T: Components<E::Real>>(e: E, i: &Inputs<E, T>) -> Outputs<T> {
    let (a, b) = (i.a.to_words(), i.b.to_words());
    let rest = e.real(1.0) - i.weight;
    let mut mixed = a;
    for k in 0..4 {
        // Exact at both ends, and no overflow of b - a.
        mixed[k] = b[k].mul_add(i.weight, a[k] * rest);
    }
    let with_a = a_shows(e, i).select(T::from_words(mixed), i.b);
    Outputs { result: b_shows(e, i).select(with_a, i.a) }
}
