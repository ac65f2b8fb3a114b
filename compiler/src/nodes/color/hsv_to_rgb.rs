use crate::emit::functions::colors::from_hsv;
use crate::nodes::NOT_NEGATIVE;
use crate::nodes::finite::UNIT;

node! {
    /// Colour from hue, saturation and value. Hue is in turns and wraps: 0 red, 1/3 green, 2/3 blue,
    /// 1 red again, below 0 and above 1 likewise. Value may exceed 1. Alpha is 1.
    ///
    /// Each component is `value (1 - saturation (1 - c))`, `c` being the component of the pure hue:
    /// no sextant is chosen, so none can be missed at its edge.
    hsv_to_rgb in color,
    source "Smith 1978, Color Gamut Transform Pairs",
    inputs {
        /// Hue in turns.
        hue: scalar = 0.0, unit "turns", soft UNIT;
        /// Saturation: 0 grey, 1 pure.
        saturation: scalar = 1.0, in UNIT;
        /// Value: the brightest component.
        value: scalar = 1.0, in NOT_NEGATIVE, soft UNIT;
    }
    outputs {
        /// The colour.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let color = from_hsv([i.hue, i.saturation, i.value], e.real(1.0));
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn rgb(hue: f32, saturation: f32, value: f32) -> Vec<f32> {
        numbers!(hue = hue, saturation = saturation, value = value => color)
    }

    #[test]
    fn known_values() {
        for (hue, saturation, value, [r, g, b]) in [
            (0.0, 1.0, 1.0, [1.0, 0.0, 0.0]),
            (1.0 / 6.0, 1.0, 1.0, [1.0, 1.0, 0.0]),
            (0.5, 1.0, 1.0, [0.0, 1.0, 1.0]),
            (2.0 / 3.0, 1.0, 1.0, [0.0, 0.0, 1.0]),
            (5.0 / 6.0, 1.0, 1.0, [1.0, 0.0, 1.0]),
            (1.0, 1.0, 1.0, [1.0, 0.0, 0.0]),
            (0.1, 1.0, 1.0, [1.0, 0.6, 0.0]),
            (0.75, 0.5, 0.8, [0.6, 0.4, 0.8]),
            (0.3, 0.0, 0.7, [0.7, 0.7, 0.7]),
            (0.3, 1.0, 0.0, [0.0, 0.0, 0.0]),
            (0.1, 0.5, 0.8, [0.8, 0.64, 0.4]),
            (0.37, 0.25, 0.6, [0.45, 0.6, 0.483]),
            (1.0 / 12.0, 1.0, 1.0, [1.0, 0.5, 0.0]),
            (0.6, 0.0, 0.4, [0.4, 0.4, 0.4]),
            (-0.2, 0.7, 0.5, [0.43, 0.15, 0.5]),
        ] {
            assert_close(&rgb(hue, saturation, value), &[r, g, b, 1.0], 4e-7, 4e-7);
        }
    }

    #[test]
    fn hue_wraps_and_never_leaves_the_gamut() {
        assert_eq!(rgb(7.25, 1.0, 1.0), rgb(0.25, 1.0, 1.0));
        assert_eq!(rgb(-0.75, 1.0, 1.0), rgb(0.25, 1.0, 1.0));
        for hue in [1.0_f32.next_down(), -1e-45, 1e30, f32::MAX, f32::MIN, f32::NAN, f32::INFINITY]
        {
            let color = rgb(hue, 1.0, 2.0);
            assert!(color[..3].iter().all(|x| (0.0..=2.0).contains(x)), "{hue}: {color:?}");
        }
    }

    #[test]
    fn grey_is_exact_and_value_may_exceed_one() {
        assert_eq!(rgb(0.3, 0.0, 0.7), [0.7, 0.7, 0.7, 1.0]);
        assert_eq!(rgb(0.0, 1.0, 30.0), [30.0, 0.0, 0.0, 1.0]);
    }
}
