use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Color, Components, Mask, Real};
use crate::nodes::BLACK;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// One picture over another by alpha. Colours are premultiplied, save for `matte`. With f
    /// the foreground, b the background and their alphas fa and ba, on all four components:
    /// `over` is `f + b (1 - fa)`; `in` is `f ba`; `out` is `f (1 - ba)`; `mask` is `b fa`;
    /// `matte` is `f fa + b (1 - fa)` with the alpha `fa + ba (1 - fa)`, `over` for straight
    /// colours; `disjoint_over` is `f + b`, and where fa + ba exceeds 1 it is `f + b (1 - fa) /
    /// ba`, with the alpha at most 1. Light brighter than 1 passes; what overflows is the
    /// largest number. At weight 0 the foreground is not evaluated and the background passes to
    /// the bit.
    composite in compositing,
    source "Porter and Duff 1984, Compositing Digital Images; MaterialX 1.39, disjointover",
    inputs {
        /// How they are joined.
        mode: choice = 0, of ["over", "in", "out", "mask", "matte", "disjoint_over"];
        /// Share of the result; the rest is the background.
        weight: scalar = 1.0, in UNIT;
        /// The picture behind.
        background: color = BLACK, in FACTOR;
        /// The picture in front.
        foreground: color = BLACK, in FACTOR, when i.weight.not_equal(e.real(0.0));
    }
    outputs {
        /// The composite.
        color: color;
    }
    body |e, i| {
        let (f, b) = (i.foreground.to_words(), i.background.to_words());
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let (share, rest) = (i.weight, one - i.weight);
        let mut color = b;
        for k in 0..4 {
            let joined = clamp_finite(joined(i.mode, k, f, b));
            color[k] = clamp_finite(joined.mul_add(share, b[k] * rest));
        }
        let kept = share.not_equal(zero);
        Outputs { color: kept.select(Color::from_words(color), i.background) }
    }
}

/// Component `k` of the whole composite.
#[inline(always)]
fn joined<R: Real>(mode: i32, k: usize, f: [R; 4], b: [R; 4]) -> R {
    let one = f[3].same(1.0);
    let (fa, ba) = (f[3], b[3]);
    match mode {
        0 => b[k].mul_add(one - fa, f[k]),
        1 => f[k] * ba,
        2 => f[k] * (one - ba),
        3 => b[k] * fa,
        4 if k < 3 => f[k].mul_add(fa, b[k] * (one - fa)),
        4 => b[k].mul_add(one - fa, f[k]),
        _ if k < 3 => {
            let share = (one - fa).divide_or_zero(ba);
            let share = (fa + ba).less_equal(one).select(one, share);
            b[k].mul_add(share, f[k])
        }
        _ => (fa + ba).minimum(one),
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const F: [f32; 4] = [0.25, 2.0, 0.5, 0.5];
    const B: [f32; 4] = [0.5, 0.25, 1.0, 0.75];

    #[test]
    fn joins_by_alpha() {
        for (mode, expected) in [
            (0, [0.5, 2.125, 1.0, 0.875]),
            (1, [0.1875, 1.5, 0.375, 0.375]),
            (2, [0.0625, 0.5, 0.125, 0.125]),
            (3, [0.25, 0.125, 0.5, 0.375]),
            (4, [0.375, 1.125, 0.75, 0.875]),
            (5, [0.25 + 1.0 / 3.0, 2.0 + 1.0 / 6.0, 0.5 + 2.0 / 3.0, 1.0]),
        ] {
            let color = numbers!(mode = mode, background = B, foreground = F => color);
            assert_close(&color, &expected, 3e-7, 0.0);
            let half = numbers!(mode = mode, background = B, foreground = F, weight = 0.5 => color);
            let between: Vec<f64> = (0..4).map(|k| (expected[k] + f64::from(B[k])) / 2.0).collect();
            assert_close(&half, &between, 3e-7, 0.0);
        }
    }

    #[test]
    fn disjoint_pictures_add_up() {
        let f = [0.25, 0.5, 1.0, 0.125];
        let color = numbers!(mode = 5, background = B, foreground = f => color);
        assert_eq!(color, [0.75, 0.75, 2.0, 0.875]);
        let clear = [0.5, 0.5, 0.5, 0.0];
        let color =
            numbers!(mode = 5, background = clear, foreground = [1.0, 1.0, 1.0, 2.0] => color);
        assert_eq!(color, [1.0; 4]);
    }

    #[test]
    fn a_weight_of_zero_leaves_the_background() {
        let color =
            numbers!(mode = 4, background = B, foreground = [f32::NAN; 4], weight = 0.0 => color);
        assert_eq!(color, B);
        assert!(!demanded!(weight = 0.0 => foreground));
    }
}
