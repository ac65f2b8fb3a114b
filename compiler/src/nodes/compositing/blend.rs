use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Mask, Real};
use crate::nodes::finite::{FACTOR, UNIT};

/// The modes, by their number.
const MODES: [&str; 19] = [
    "mix",
    "add",
    "subtract",
    "multiply",
    "divide",
    "screen",
    "overlay",
    "hard_light",
    "soft_light",
    "linear_light",
    "linear_burn",
    "burn",
    "dodge",
    "darken",
    "lighten",
    "difference",
    "exclusion",
    "negation",
    "average",
];

node! {
    /// Layer modes, per component, of the base a and the layer b: `mix` b; `add`; `subtract` a
    /// - b; `multiply`; `divide`, 0 where b is 0; `screen` a + b - a b; `overlay` 2 a b where a
    /// is below one half, else 1 - 2 (1 - a)(1 - b); `hard_light` is overlay decided by b;
    /// `soft_light` a ((1 - a) b + screen); `linear_light` a + 2 b - 1; `linear_burn` a + b -
    /// 1; `burn` 1 - (1 - a) / b and `dodge` a / (1 - b), 0 where the divisor is 0; `darken`;
    /// `lighten`; `difference` |a - b|; `exclusion` a + b - 2 a b; `negation` 1 - |1 - a - b|;
    /// `average`.
    ///
    /// Nothing is clamped, so light above 1 follows the formulas: screen, overlay, exclusion
    /// and negation then turn round, burn and the linear modes may be negative, and dodge is
    /// negative for layers above 1. Blender clamps burn and dodge to 0..1 and dodge of a full
    /// layer gives 1; for bright light the nodes `screen` and `overlay` are made. The weight
    /// mixes with the base: at 0 the layer is not evaluated. MaterialX calls base and layer bg
    /// and fg, and blends alpha too; here the alpha of the base stays.
    blend in compositing per component,
    source "MaterialX 1.39, compositing nodes; Blender, Mix Color; Pegtop, Blend Modes",
    inputs {
        /// What is below.
        base: generic = 0.0, in FACTOR;
        /// The mode.
        mode: choice = 0, of MODES;
        /// Share of the result; the rest is the base.
        weight: scalar = 1.0, in UNIT;
        /// What is laid over it.
        layer: generic = 0.0, in FACTOR, when i.weight.not_equal(e.real(0.0));
    }
    outputs {
        /// The blend.
        result: generic;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let blended = clamp_finite(blended(i.mode, i.base, i.layer));
        let mixed = clamp_finite(blended.mul_add(i.weight, i.base * (one - i.weight)));
        i.weight.not_equal(zero).select(mixed, i.base)
    }
}

/// A component at full weight.
#[inline(always)]
fn blended<R: Real>(mode: i32, a: R, b: R) -> R {
    let one = a.same(1.0);
    match mode {
        0 => b,
        1 => a + b,
        2 => a - b,
        3 => a * b,
        4 => a.divide_or_zero(b),
        5 => screen(a, b),
        6 => overlay(a, b, a),
        7 => overlay(a, b, b),
        8 => a * b.mul_add(one - a, screen(a, b)),
        9 => a + (b * 2.0 - 1.0),
        10 => a + (b - 1.0),
        11 => b.equal(a.same(0.0)).select(b, one - (one - a) / b),
        12 => a.divide_or_zero(one - b),
        13 => a.minimum(b),
        14 => a.maximum(b),
        15 => (a - b).absolute(),
        16 => a + b - a * b * 2.0,
        17 => one - (one - a - b).absolute(),
        _ => a * 0.5 + b * 0.5,
    }
}

#[inline(always)]
fn screen<R: Real>(a: R, b: R) -> R {
    b.mul_add(a.same(1.0) - a, a)
}

/// Multiplies twice where `by` is dark, screens where it is bright.
#[inline(always)]
fn overlay<R: Real>(a: R, b: R, by: R) -> R {
    let one = a.same(1.0);
    let bright = one - (one - a) * (one - b) * 2.0;
    by.less(a.same(0.5)).select(a * b * 2.0, bright)
}

#[cfg(test)]
mod tests {
    use super::MODES;
    use crate::nodes::harness::assert_close;

    fn blended(mode: &str, base: [f32; 4], layer: [f32; 4]) -> Vec<f32> {
        let mode = MODES.iter().position(|&it| it == mode).expect("a mode") as i32;
        numbers!(base = base, mode = mode, layer = layer => result)
    }

    const BASE: [f32; 4] = [0.2, 0.5, 0.8, 0.5];
    const LAYER: [f32; 4] = [0.6, 0.3, 0.9, 1.0];

    #[test]
    fn agrees_with_the_peers() {
        for (mode, expected) in [
            ("overlay", [0.24, 0.3, 0.96]),
            ("screen", [0.68, 0.65, 0.98]),
            ("difference", [0.4, 0.2, 0.1]),
            ("soft_light", [0.232, 0.4, 0.928]),
            ("linear_light", [0.4, 0.1, 1.6]),
            ("exclusion", [0.56, 0.5, 0.26]),
            // As MaterialX; Cycles clamps to 0, 0, 0.777778 and 0.5, 0.714286, 1.
            ("burn", [-1.0 / 3.0, -2.0 / 3.0, 0.777_777_8]),
            ("dodge", [0.5, 0.714_285_7, 8.0]),
            ("hard_light", [0.36, 0.3, 0.96]),
            ("darken", [0.2, 0.3, 0.8]),
            ("lighten", [0.6, 0.5, 0.9]),
            ("linear_burn", [-0.2, -0.2, 0.7]),
            ("negation", [0.8, 0.8, 0.3]),
            ("average", [0.4, 0.4, 0.85]),
            ("divide", [1.0 / 3.0, 5.0 / 3.0, 8.0 / 9.0]),
            ("mix", [0.6, 0.3, 0.9]),
        ] {
            let color = blended(mode, BASE, LAYER);
            assert_close(&color[..3], &expected, 2e-6, 1e-7);
            assert_eq!(color[3], 0.5, "alpha of the base");
        }
    }

    #[test]
    fn bright_and_negative_light_follows_the_formulas() {
        let (base, layer) = ([2.0, -1.0, 3.0, 1.0], [2.0, 0.5, -2.0, 1.0]);
        for (mode, expected) in [
            ("screen", [0.0, 0.0, 7.0]),
            ("overlay", [-1.0, -1.0, 13.0]),
            ("dodge", [-2.0, -2.0, 1.0]),
            ("burn", [1.5, -3.0, 0.0]),
            ("difference", [0.0, 1.5, 5.0]),
            ("exclusion", [-4.0, 0.5, 13.0]),
            ("negation", [-2.0, -0.5, 1.0]),
        ] {
            assert_close(&blended(mode, base, layer)[..3], &expected, 1e-6, 0.0);
        }
        for mode in MODES {
            for x in [1e19, -1e19] {
                let extreme = blended(mode, [x, -x, 0.0, 1.0], [x, x, x, 1.0]);
                assert!(extreme.iter().all(|x| x.is_finite()), "{mode}");
            }
        }
    }

    #[test]
    fn divisors_of_zero_give_zero() {
        assert_eq!(blended("burn", [0.5; 4], [0.0; 4])[0], 0.0);
        assert_eq!(blended("dodge", [0.5; 4], [1.0; 4])[0], 0.0);
        assert_eq!(blended("divide", [0.5; 4], [0.0; 4])[0], 0.0);
    }

    #[test]
    fn a_weight_of_zero_leaves_the_base() {
        assert!(!demanded!(weight = 0.0 => layer));
        assert_eq!(number!(base = 0.3, weight = 0.0, layer = f32::NAN => result), 0.3);
        assert_eq!(number!(base = 1.0, weight = 0.25, layer = 3.0 => result), 1.5);
    }
}
