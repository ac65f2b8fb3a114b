use crate::emit::functions::colors::{XYZ_TO_REC709, srgb_decoded, weighted};
use crate::emit::functions::conventions::pow_or_zero;
use crate::emit::{Color, Real};
use crate::nodes::BLACK;

/// The spaces, by their number.
const SPACES: [&str; 11] = [
    "srgb",
    "gamma_1_8",
    "gamma_2_2",
    "rec709_display",
    "acescg",
    "acescg_gamma_2_2",
    "adobe_rgb",
    "linear_adobe_rgb",
    "display_p3",
    "linear_display_p3",
    "xyz",
];

/// ACEScg: AP1 primaries, white at x = 0.32168, y = 0.33767.
const ACES: [[f64; 3]; 3] = [
    [1.705_050_992_66, -0.621_792_120_657, -0.083_258_872_001],
    [-0.130_256_417_507, 1.140_804_736_58, -0.010_548_319_068_4],
    [-0.024_003_356_804_6, -0.128_968_976_065, 1.152_972_332_87],
];
/// Adobe RGB (1998), white at D65.
const ADOBE: [[f64; 3]; 3] = [
    [1.398_355_743_96, -0.398_355_743_961, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -0.042_928_989_294_5, 1.042_928_989_29],
];
/// Display P3: the primaries of DCI-P3, white at D65.
const DISPLAY_P3: [[f64; 3]; 3] = [
    [1.224_940_176_28, -0.224_940_176_281, 0.0],
    [-0.042_056_954_709_7, 1.042_056_954_71, 0.0],
    [-0.019_637_554_590_3, -0.078_636_045_550_6, 1.098_273_600_14],
];

/// How components are encoded.
#[derive(Clone, Copy)]
enum Curve {
    Srgb,
    Power(f64),
}

node! {
    /// Linear Rec. 709 of a colour in another space: its curve, then its primaries. Curves of
    /// powers take negative components as 0; sRGB's are mirrored. `linear_*` spaces have no
    /// curve, and what lies outside Rec. 709 has negative components. ACES' white is adapted by
    /// Bradford's transform. `xyz` is CIE 1931 with white at D65. The numbers come from the
    /// primaries in the standards; MaterialX's of Display P3 differ in the sixth digit.
    /// Pictures are decoded when they are read, see `space` of a texture. Alpha is kept.
    decode_color in color,
    source "IEC 61966-2-1; ITU-R BT.709; SMPTE ST 2065-1 and S-2014-004; Adobe RGB (1998); SMPTE RP 431-2",
    inputs {
        /// The colour in its space.
        color: color = BLACK, in -1e6..=1e6;
        /// The space.
        space: choice = 0, of SPACES;
    }
    outputs {
        /// The colour in linear Rec. 709.
        color: color;
    }
    body |e, i| {
        let color = match i.space {
            0 | 8 => each(i.color, Curve::Srgb),
            1 => each(i.color, Curve::Power(1.8)),
            2 | 5 => each(i.color, Curve::Power(2.2)),
            3 => each(i.color, Curve::Power(2.4)),
            6 => each(i.color, Curve::Power(563.0 / 256.0)),
            _ => i.color,
        };
        let color = match i.space {
            4 | 5 => weighted(color, &ACES),
            6 | 7 => weighted(color, &ADOBE),
            8 | 9 => weighted(color, &DISPLAY_P3),
            10 => weighted(color, &XYZ_TO_REC709),
            _ => color,
        };
        Outputs { color }
    }
}

/// Each component made linear.
#[inline(always)]
fn each<R: Real>(color: Color<R>, curve: Curve) -> Color<R> {
    Color {
        r: linear(color.r, curve),
        g: linear(color.g, curve),
        b: linear(color.b, curve),
        a: color.a,
    }
}

#[inline(always)]
fn linear<R: Real>(x: R, curve: Curve) -> R {
    match curve {
        Curve::Srgb => srgb_decoded(x),
        Curve::Power(gamma) => pow_or_zero(x.maximum(x.same(0.0)), x.same(gamma)),
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const GREY_AND_MORE: [[f32; 4]; 2] = [[0.5, 0.25, 0.75, 0.5], [1.0, 1.0, 1.0, 0.5]];

    #[test]
    fn white_stays_white() {
        for space in 0..10 {
            let white = numbers!(color = GREY_AND_MORE[1], space = space => color);
            assert_close(&white, &[1.0, 1.0, 1.0, 0.5], 2e-6, 0.0);
        }
    }

    #[test]
    fn agrees_with_the_peers() {
        for (space, expected, bound) in [
            (0, [0.214_041_129, 0.050_876_092_2, 0.522_521_675], 1e-6),
            (1, [0.287_174_612, 0.082_469_254_7, 0.595_813_394], 1e-6),
            (2, [0.217_637_643, 0.047_366_142_3, 0.531_049_311], 1e-6),
            (3, [0.189_464_569, 0.035_896_819_1, 0.501_356_959], 1e-6),
            (4, [0.634_633_183, 0.212_162_256, 0.820_485_234], 4e-6),
            (5, [0.297_416_747, 0.020_085_416_7, 0.600_952_268], 3e-5),
            (6, [0.285_610_706, 0.047_417_473, 0.551_935_673], 4e-6),
            (7, [0.599_588_99, 0.25, 0.771_464_527], 1e-6),
            (8, [0.250_741_869, 0.044_013_53, 0.565_674_543], 3e-5),
            (9, [0.556_232_512, 0.239_485_234, 0.794_234_276], 3e-5),
        ] {
            let decoded = numbers!(color = GREY_AND_MORE[0], space = space => color);
            assert_close(&decoded[..3], &expected, bound, 0.0);
            assert_eq!(decoded[3], 0.5);
        }
    }

    #[test]
    fn xyz_of_white_is_white() {
        let white = numbers!(color = [0.950_455_9, 1.0, 1.089_057_8, 1.0], space = 10 => color);
        assert_close(&white, &[1.0; 4], 1e-6, 0.0);
    }
}
