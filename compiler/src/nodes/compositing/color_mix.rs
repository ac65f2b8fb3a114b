use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Color, Components, Real};
use crate::nodes::BLACK;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// One layer of mental ray's mib_color_mix, on all four components, with r the colour so
    /// far, c the layer and w the weight: `blend` is `(r (1 - ca) + c) w`, so the weight scales
    /// r too; `mix` is `r (1 - w) + c w`; `add` is `r + c w`, and `bounded_add` the same
    /// clamped to 0..1; `multiply` is `r c w`, and `bounded_multiply` the same clamped;
    /// `replace_alpha` is `r w` with the alpha of the layer. What overflows is the largest
    /// number.
    color_mix in compositing,
    source "mental ray base shaders, mib_color_mix",
    inputs {
        /// How the layer is joined.
        mode: choice = 0, of ["blend", "mix", "add", "bounded_add", "multiply", "bounded_multiply", "replace_alpha"];
        /// Weight of the layer.
        weight: scalar = 1.0, in FACTOR, soft UNIT;
        /// The colour so far.
        base: color = BLACK, in FACTOR;
        /// The layer.
        layer: color = BLACK, in FACTOR;
    }
    outputs {
        /// The colour with the layer.
        color: color;
    }
    body |e, i| {
        let (base, layer) = (i.base.to_words(), i.layer.to_words());
        let mut color = base;
        for k in 0..4 {
            color[k] = clamp_finite(mixed(i.mode, base[k], layer[k], layer[3], i.weight));
        }
        if i.mode == 6 {
            color[3] = layer[3];
        }
        Outputs { color: Color::from_words(color) }
    }
}

/// A component.
#[inline(always)]
fn mixed<R: Real>(mode: i32, base: R, layer: R, alpha: R, weight: R) -> R {
    let one = base.same(1.0);
    match mode {
        0 => base.mul_add(one - alpha, layer) * weight,
        1 => layer.mul_add(weight, base * (one - weight)),
        2 => layer.mul_add(weight, base),
        3 => layer.mul_add(weight, base).saturate(),
        4 => base * layer * weight,
        5 => (base * layer * weight).saturate(),
        _ => base * weight,
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn joins_as_mental_ray_does() {
        let (base, layer) = ([0.5, 2.0, 0.0, 1.0], [0.25, 1.0, 0.5, 0.5]);
        for (mode, expected) in [
            (0, [0.25, 1.0, 0.25, 0.5]),
            (1, [0.375, 1.5, 0.25, 0.75]),
            (2, [0.625, 2.5, 0.25, 1.25]),
            (3, [0.625, 1.0, 0.25, 1.0]),
            (4, [0.0625, 1.0, 0.0, 0.25]),
            (5, [0.0625, 1.0, 0.0, 0.25]),
            (6, [0.25, 1.0, 0.0, 0.5]),
        ] {
            let color = numbers!(mode = mode, weight = 0.5, base = base, layer = layer => color);
            assert_eq!(color, expected, "{mode}");
        }
    }
}
