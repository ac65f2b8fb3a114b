use crate::emit::functions::colors::{from_hsv, to_hsv};
use crate::emit::functions::conventions::clamp_finite;
use crate::emit::{Color, Real};
use crate::nodes::BLACK;
use crate::nodes::finite::FACTOR;

node! {
    /// A colour with another hue, saturation and value: `hue` is added in turns, saturation and
    /// value are multiplied, so 0, 1, 1 changes nothing. Saturation stays at 0 or above; grey
    /// stays grey. Blender's node is neutral at a hue of one half, and clamps saturation at 1.
    /// A colour keeps its alpha.
    adjust_hsv in color,
    source "Smith 1978, Color Gamut Transform Pairs",
    inputs {
        /// The colour.
        color: color = BLACK, in FACTOR;
        /// Turns that are added to the hue.
        hue: scalar = 0.0, in FACTOR, unit "turns", soft -0.5..=0.5;
        /// Factor on the saturation.
        saturation: scalar = 1.0, in 0.0..=1e6, soft 0.0..=2.0;
        /// Factor on the value.
        value: scalar = 1.0, in -1e6..=1e6, soft 0.0..=2.0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| {
        let [hue, saturation, value] = to_hsv(i.color);
        let saturation = clamp_finite(saturation * i.saturation).maximum(e.real(0.0));
        let color = from_hsv([hue + i.hue, saturation, value * i.value], i.color.a);
        let finite = Color {
            r: clamp_finite(color.r),
            g: clamp_finite(color.g),
            b: clamp_finite(color.b),
            a: color.a,
        };
        Outputs { color: finite }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn turns_hues_and_scales() {
        let close = crate::nodes::harness::assert_close;
        let red = [0.8, 0.2, 0.2, 0.5];
        close(&numbers!(color = red => color), &[0.8, 0.2, 0.2, 0.5], 3e-7, 0.0);
        close(
            &numbers!(color = red, hue = 1.0_f32 / 3.0 => color),
            &[0.2, 0.8, 0.2, 0.5],
            1e-6,
            0.0,
        );
        close(&numbers!(color = red, saturation = 0.0 => color), &[0.8, 0.8, 0.8, 0.5], 3e-7, 0.0);
        close(&numbers!(color = red, value = 10.0 => color), &[8.0, 2.0, 2.0, 0.5], 1e-6, 0.0);
    }

    #[test]
    fn negative_colours_stay_finite() {
        for color in [[-1.0, -2.0, -3.0, 1.0], [-1e19, 1e-19, 0.0, 1.0], [0.0, 0.0, 0.0, 1.0]] {
            assert!(numbers!(color = color, hue = 0.7 => color).iter().all(|x| x.is_finite()));
        }
    }
}
