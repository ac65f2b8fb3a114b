use crate::emit::{Color, Components, Mask, Real};
use crate::nodes::finite::{FACTOR, UNIT};

node! {
    /// Blends what was read at the three places of `hex_tile_places`. The shares are `w^7`, times the brightness of
    /// each by the part `contrast`, divided by their sum: the seventh power keeps patches apart, and bright details win
    /// over dark ones instead of fading into them. What has no weight is not evaluated. Alpha is blended too.
    ///
    /// For maps of normals and other data `contrast` is 0. Brightness is the luminance of Rec. 709, and below
    /// 10^-4 it counts as that. MaterialX calls `contrast` `falloffcontrast`; its `falloff` is left at 0.5.
    hex_tile_blend in textures,
    source "Mikkelsen 2022, Practical Real-Time Hex-Tiling, JCGT 11 (3); MaterialX 1.39, hextiledimage",
    inputs {
        /// How much there is of each.
        weights: vector = [1.0, 0.0, 0.0], in UNIT;
        /// How much brightness counts.
        contrast: scalar = 0.5, in UNIT;
        /// What was read at the first place.
        first: color = [0.0; 4], in FACTOR, when i.weights.x.not_equal(e.real(0.0));
        /// What was read at the second place.
        second: color = [0.0; 4], in FACTOR, when i.weights.y.not_equal(e.real(0.0));
        /// What was read at the third place.
        third: color = [0.0; 4], in FACTOR, when i.weights.z.not_equal(e.real(0.0));
    }
    outputs {
        /// The blend.
        color: color;
    }
    body |e, i| {
        let weights = i.weights.to_words();
        let colors = [i.first, i.second, i.third];
        let zero = e.real(0.0);
        let (mut sum, mut whole) = (Color { r: zero, g: zero, b: zero, a: zero }, zero);
        for k in 0..3 {
            let shows = weights[k].not_equal(zero);
            let share = shows.select(share(weights[k], colors[k], i.contrast), zero);
            let color = colors[k].to_words().map(|word| shows.select(word, zero) * share);
            let before = sum.to_words();
            sum = Color {
                r: before[0] + color[0],
                g: before[1] + color[1],
                b: before[2] + color[2],
                a: before[3] + color[3],
            };
            whole = whole + share;
        }
        Outputs { color: Color {
            r: sum.r.divide_or_zero(whole),
            g: sum.g.divide_or_zero(whole),
            b: sum.b.divide_or_zero(whole),
            a: sum.a.divide_or_zero(whole),
        } }
    }
}

/// The share of a colour before all are divided by their sum. Neither vanishes nor overflows where the weight is
/// that of a place.
#[inline(always)]
fn share<R: Real>(weight: R, color: Color<R>, contrast: R) -> R {
    let brightness = color.r * 0.2126 + color.g * 0.7152 + color.b * 0.0722;
    let brightness = brightness.clamp_to(weight.same(1e-4), weight.same(1e4));
    let counted = contrast.mul_add(brightness - 1.0, weight.same(1.0));
    let cubed = weight * weight * weight;
    cubed * cubed * weight * counted
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn shares_are_those_of_the_formula() {
        let (a, b) = ([0.5, 0.5, 0.5, 1.0], [0.1, 0.1, 0.1, 0.0]);
        let weights = [0.6, 0.4, 0.0];
        for contrast in [0.0, 0.5, 1.0] {
            let of = |weight: f64, brightness: f64| {
                weight.powi(7) * (1.0 + f64::from(contrast) * (brightness - 1.0))
            };
            let (first, second) = (of(0.6, 0.5), of(0.4, 0.1));
            let share = first / (first + second);
            let expected = 0.5 * share + 0.1 * (1.0 - share);
            let found =
                numbers!(weights = weights, contrast = contrast, first = a, second = b => color);
            assert_close(&found, &[expected, expected, expected, share], 1e-6, 1e-6);
        }
    }

    #[test]
    fn what_has_no_weight_is_not_evaluated_and_does_not_show() {
        assert!(demanded!(weights = [0.5, 0.0, 0.5] => first));
        assert!(!demanded!(weights = [0.5, 0.0, 0.5] => second));
        let (red, garbage) = ([1.0, 0.0, 0.0, 1.0], [f32::NAN; 4]);
        let found = numbers!(weights = [0.0, 1.0, 0.0], first = garbage, second = red, third = garbage => color);
        assert_eq!(found, red);
        let black = [0.0, 0.0, 0.0, 1.0];
        let found = numbers!(weights = [1.0, 0.0, 0.0], contrast = 1.0, first = black => color);
        assert_eq!(found, black);
        assert_eq!(numbers!(weights = [0.0; 3] => color), [0.0; 4]);
    }
}
