use crate::emit::functions::colors::to_hsv;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::finite::{SUMMAND, UNIT};
use crate::nodes::{BLACK, NOT_NEGATIVE};

node! {
    /// Hue, saturation and value of a colour: hue in turns, from red 0 over green 1/3 and blue
    /// 2/3; value the largest component, which may exceed 1; saturation what is missing of it
    /// in the smallest, above 1 where that is negative. Of grey hue and saturation are 0, and
    /// so they are where no component is above zero. `hsv_to_rgb` is the way back.
    rgb_to_hsv in color,
    source "Smith 1978, Color Gamut Transform Pairs",
    inputs {
        /// The colour.
        color: color = BLACK, in SUMMAND;
    }
    outputs {
        /// Hue in turns.
        hue: scalar, in UNIT;
        /// Saturation: 0 grey, 1 pure.
        saturation: scalar, in NOT_NEGATIVE;
        /// Value: the largest component.
        value: scalar;
    }
    body |e, i| {
        let [hue, saturation, value] = to_hsv(i.color);
        Outputs { hue, saturation: clamp_finite(saturation), value }
    }
}

#[cfg(test)]
mod tests {
    fn hsv(color: [f32; 4]) -> Vec<f32> {
        ["hue", "saturation", "value"]
            .map(|output| {
                let given = [("color", color.into())];
                crate::nodes::harness::numbers(&super::definition(), &given, output)[0]
            })
            .to_vec()
    }

    #[test]
    fn agrees_with_the_peers() {
        let close = crate::nodes::harness::assert_close;
        close(&hsv([0.1, 0.5, 0.9, 1.0]), &[0.583_333_333, 0.888_888_889, 0.9], 3e-7, 0.0);
        close(&hsv([2.0, 0.5, 0.25, 1.0]), &[0.023_809_523_8, 0.875, 2.0], 3e-7, 0.0);
    }

    #[test]
    fn grey_black_and_negative_colours_have_one() {
        assert_eq!(hsv([0.4, 0.4, 0.4, 1.0]), [0.0, 0.0, 0.4]);
        assert_eq!(hsv([0.0, 0.0, 0.0, 1.0]), [0.0; 3]);
        assert_eq!(hsv([-1.0, -2.0, -3.0, 1.0]), [0.0, 0.0, -1.0]);
        assert_eq!(hsv([-1.0, 0.5, 0.5, 1.0]), [0.5, 3.0, 0.5]);
        assert_eq!(hsv([0.0, 0.0, 1e-45, 1.0])[1..], [1.0, 1e-45]);
    }

    #[test]
    fn hues_go_round() {
        for (color, sextant) in [
            ([1.0, 0.0, 0.0], 0.0),
            ([1.0, 1.0, 0.0], 1.0),
            ([0.0, 1.0, 0.0], 2.0),
            ([0.0, 1.0, 1.0], 3.0),
            ([0.0, 0.0, 1.0], 4.0),
            ([1.0, 0.0, 1.0], 5.0),
        ] {
            let [r, g, b] = color;
            crate::nodes::harness::assert_close(
                &hsv([r, g, b, 1.0])[..1],
                &[sextant / 6.0],
                3e-7,
                0.0,
            );
        }
    }
}
