use crate::emit::functions::colors::{from_hsv, to_hsv};
use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Color, Mask, Real};
use crate::nodes::BLACK;
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// Layer modes of hue, saturation and value: the base with the hue of the layer, with its
    /// saturation, with both (`color`), or with its value. A grey layer has no hue, and in the
    /// modes `hue` and `color` leaves the base; a grey base has none to keep, and in the mode
    /// `saturation` stays. At weight 0 the layer is not evaluated. The alpha is that of the
    /// base.
    blend_hue in compositing,
    source "Smith 1978, Color Gamut Transform Pairs; Blender, Mix Color",
    inputs {
        /// What of the layer is taken.
        mode: choice = 0, of ["hue", "saturation", "color", "value"];
        /// Share of the result; the rest is the base.
        weight: scalar = 1.0, in UNIT;
        /// What is below.
        base: color = BLACK, in FACTOR;
        /// What is laid over it.
        layer: color = BLACK, in FACTOR, when i.weight.not_equal(e.real(0.0));
    }
    outputs {
        /// The blend.
        color: color;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let (base, layer) = (to_hsv(i.base), to_hsv(i.layer));
        let taken = match i.mode {
            0 => [layer[0], base[1], base[2]],
            1 => [base[0], layer[1], base[2]],
            2 => [layer[0], layer[1], base[2]],
            _ => [base[0], base[1], layer[2]],
        };
        let blended = from_hsv(taken, i.base.a);
        let has_hue = match i.mode {
            0 | 2 => layer[1].not_equal(zero),
            1 => base[1].not_equal(zero),
            _ => e.mask(true),
        };
        let (blended, base) = (has_hue.select(blended, i.base), i.base);
        let (share, rest) = (i.weight, one - i.weight);
        let color = Color {
            r: clamp_finite(clamp_finite(blended.r).mul_add(share, base.r * rest)),
            g: clamp_finite(clamp_finite(blended.g).mul_add(share, base.g * rest)),
            b: clamp_finite(clamp_finite(blended.b).mul_add(share, base.b * rest)),
            a: base.a,
        };
        Outputs { color: share.not_equal(zero).select(color, base) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn takes_parts_of_the_layer() {
        let (base, layer) = ([0.8, 0.2, 0.2, 0.5], [0.0, 0.5, 0.0, 1.0]);
        for (mode, expected) in [
            (0, [0.2, 0.8, 0.2, 0.5]),
            (1, [0.8, 0.0, 0.0, 0.5]),
            (2, [0.0, 0.8, 0.0, 0.5]),
            (3, [0.5, 0.125, 0.125, 0.5]),
        ] {
            let color = numbers!(mode = mode, base = base, layer = layer => color);
            assert_close(&color, &expected, 1e-6, 1e-7);
        }
    }

    #[test]
    fn grey_has_no_hue_to_give() {
        let base = [0.8, 0.2, 0.2, 0.5];
        for mode in [0, 2] {
            assert_eq!(numbers!(mode = mode, base = base, layer = [0.5; 4] => color), base);
        }
        assert_eq!(numbers!(mode = 1, base = [0.5; 4], layer = base => color), [0.5; 4]);
        assert!(!demanded!(weight = 0.0 => layer));
    }
}
