use crate::emit::Real;
use crate::emit::functions::colors::{Hue, hue_of};
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::BLACK;
use crate::nodes::finite::{SUMMAND, UNIT};

node! {
    /// Hue, saturation and lightness of a colour: hue in turns as in `rgb_to_hsv`; lightness
    /// half the sum of the largest and the smallest component; saturation their difference over
    /// `1 - |2 lightness - 1|`. Made for colours in 0..1; of brighter ones the saturation is
    /// negative, and `hsl_to_rgb` is the way back all the same, save for a lightness of exactly
    /// 0 or 1.
    rgb_to_hsl in color,
    source "Joblove and Greenberg 1978, Color Spaces for Computer Graphics",
    inputs {
        /// The colour.
        color: color = BLACK, in SUMMAND;
    }
    outputs {
        /// Hue in turns.
        hue: scalar, in UNIT;
        /// Saturation: 0 grey, 1 pure.
        saturation: scalar;
        /// Lightness: 0 black, 1 white.
        lightness: scalar;
    }
    body |e, i| {
        let Hue { hue, largest, smallest } = hue_of(i.color);
        let lightness = largest * 0.5 + smallest * 0.5;
        let room = e.real(1.0) - (lightness * 2.0 - 1.0).absolute();
        let saturation = clamp_finite((largest - smallest).divide_or_zero(room));
        Outputs { hue, saturation, lightness }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_that_of_the_definition() {
        let color = [0.75, 0.25, 0.5, 1.0];
        assert_eq!(number!(color = color => lightness), 0.5);
        assert_eq!(number!(color = color => saturation), 0.5);
        let hue = number!(color = color => hue);
        assert!((hue - 11.0 / 12.0).abs() < 1e-6);
        assert_eq!(number!(color = [1.0, 1.0, 1.0, 1.0] => saturation), 0.0);
    }
}
