use crate::emit::functions::colors::{XYZ_TO_REC709, weighted};
use crate::emit::{Color, Mask, Real};
use crate::nodes::NOT_NEGATIVE;

node! {
    /// Colour of a body that glows at a temperature, at a luminance of 1: scale it for
    /// brightness. The chromaticity of Planck's locus by cubic fits, good to 0.001 from 1667 K
    /// to 25000 K, clamped there; what lies outside Rec. 709 is clipped at 0, which is blue
    /// below 1900 K. Daylight is near 6500, a bulb near 2850. MaterialX has the same fits; OSL
    /// and mental ray give radiance, which is not normalised. Alpha is 1.
    blackbody in color,
    source "Kang et al. 2002, Design of Advanced Color Temperature Control System for HDTV Applications; ITU-R BT.709",
    inputs {
        /// Temperature.
        temperature: scalar = 6500.0, in 1667.0..=25000.0, unit "kelvin";
    }
    outputs {
        /// The colour, of luminance 1.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let (one, kilo) = (e.real(1.0), e.real(1000.0));
        let temperature = i.temperature.clamp_to(e.real(1667.0), e.real(25000.0));
        let t = kilo / temperature;
        let is_cool = temperature.less(e.real(4000.0));
        let cool = cubic(t, [-0.266_123_9, -0.234_358, 0.877_695_6, 0.179_91]);
        let hot = cubic(t, [-3.025_846_9, 2.107_037_9, 0.222_634_7, 0.240_39]);
        let x = is_cool.select(cool, hot);
        let low = cubic(x, [-1.106_381_4, -1.348_110_2, 2.185_558_32, -0.202_196_83]);
        let middle = cubic(x, [-0.954_947_6, -1.374_185_93, 2.091_370_15, -0.167_488_67]);
        let high = cubic(x, [3.081_758, -5.873_386_7, 3.751_129_97, -0.370_014_83]);
        let y = temperature.less(e.real(2222.0)).select(low, is_cool.select(middle, high));
        let xyz = Color { r: x / y, g: one, b: (one - x - y) / y, a: one };
        let color = weighted(xyz, &XYZ_TO_REC709);
        let zero = e.real(0.0);
        let seen = Color {
            r: color.r.maximum(zero),
            g: color.g.maximum(zero),
            b: color.b.maximum(zero),
            a: one,
        };
        Outputs { color: seen }
    }
}

/// A polynomial of third degree, the highest coefficient first.
#[inline(always)]
fn cubic<R: Real>(x: R, [a, b, c, d]: [f64; 4]) -> R {
    x.mul_add(x.mul_add(x.mul_add(x.same(a), x.same(b)), x.same(c)), x.same(d))
}

#[cfg(test)]
mod tests {
    /// Chromaticity and luminance of a linear Rec. 709 colour.
    fn chromaticity(color: &[f32]) -> [f64; 3] {
        let [r, g, b] = [color[0], color[1], color[2]].map(f64::from);
        let x = 0.412_390_8 * r + 0.357_584_3 * g + 0.180_480_8 * b;
        let y = 0.212_639_0 * r + 0.715_168_7 * g + 0.072_192_3 * b;
        let z = 0.019_330_8 * r + 0.119_194_8 * g + 0.950_532_2 * b;
        [x / (x + y + z), y / (x + y + z), y]
    }

    #[test]
    fn lies_on_the_locus() {
        // CIE standard illuminant A, and the chromaticities of Planck's law by CIE 15.
        for (temperature, x, y) in [
            (2856.0, 0.447_58, 0.407_45),
            (4000.0, 0.380_45, 0.376_75),
            (6500.0, 0.313_52, 0.323_63),
            (10_000.0, 0.280_63, 0.288_28),
        ] {
            let color = numbers!(temperature = temperature => color);
            let [at_x, at_y, luminance] = chromaticity(&color);
            assert!(
                (at_x - x).abs() < 1e-3 && (at_y - y).abs() < 1e-3,
                "{temperature}: {at_x} {at_y}"
            );
            assert!((luminance - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn is_clamped_at_both_ends_and_never_negative() {
        let at = |temperature: f32| numbers!(temperature = temperature => color);
        assert_eq!(at(0.0), at(1667.0));
        assert_eq!(at(1e9), at(25_000.0));
        assert_eq!(at(1667.0)[2], 0.0);
        assert!(at(25_000.0)[2] > at(25_000.0)[0]);
    }
}
