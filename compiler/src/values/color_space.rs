//! Spaces in which colours may be written, and the way from them to scene-linear Rec. 709.

/// A space of colours: primaries, white and how values are encoded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorSpace {
    /// Its name in graph files: MaterialX's, but for `srgb`.
    pub name: &'static str,
    encoding: Encoding,
    /// None for those of Rec. 709.
    gamut: Option<&'static Gamut>,
}

/// How values are encoded.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Encoding {
    /// They are proportional to light.
    Linear,
    /// IEC 61966-2-1.
    Srgb,
    /// Light to the power of one over this.
    Power(f64),
}

/// Chromaticities, x and y each, of red, green, blue and white.
#[derive(Debug, PartialEq)]
struct Gamut {
    primaries: [[f64; 2]; 3],
    white: [f64; 2],
}

type Matrix = [[f64; 3]; 3];

const D65: [f64; 2] = [0.3127, 0.3290];
const REC_709: Gamut =
    Gamut { primaries: [[0.640, 0.330], [0.300, 0.600], [0.150, 0.060]], white: D65 };
/// ACES' AP1, with the white of ACES.
static AP1: Gamut = Gamut {
    primaries: [[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]],
    white: [0.32168, 0.33767],
};
static ADOBE_RGB: Gamut =
    Gamut { primaries: [[0.640, 0.330], [0.210, 0.710], [0.150, 0.060]], white: D65 };
static DISPLAY_P3: Gamut =
    Gamut { primaries: [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], white: D65 };

const fn space(
    name: &'static str,
    encoding: Encoding,
    gamut: Option<&'static Gamut>,
) -> ColorSpace {
    ColorSpace { name, encoding, gamut }
}

impl ColorSpace {
    /// Every space.
    pub const ALL: [ColorSpace; 15] = [
        space("srgb", Encoding::Srgb, None),
        space("srgb_texture", Encoding::Srgb, None),
        space("g22_rec709", Encoding::Power(2.2), None),
        space("g18_rec709", Encoding::Power(1.8), None),
        space("rec709_display", Encoding::Power(2.4), None),
        space("lin_rec709", Encoding::Linear, None),
        space("lin_srgb", Encoding::Linear, None),
        space("acescg", Encoding::Linear, Some(&AP1)),
        space("lin_ap1", Encoding::Linear, Some(&AP1)),
        space("g22_ap1", Encoding::Power(2.2), Some(&AP1)),
        space("g18_ap1", Encoding::Power(1.8), Some(&AP1)),
        space("adobergb", Encoding::Power(563.0 / 256.0), Some(&ADOBE_RGB)),
        space("lin_adobergb", Encoding::Linear, Some(&ADOBE_RGB)),
        space("srgb_displayp3", Encoding::Srgb, Some(&DISPLAY_P3)),
        space("lin_displayp3", Encoding::Linear, Some(&DISPLAY_P3)),
    ];

    /// The space called so.
    pub fn find(name: &str) -> Option<ColorSpace> {
        Self::ALL.into_iter().find(|space| space.name == name)
    }

    /// Whether its values are encoded for a display or a file: they are 0 to 1 then.
    pub fn is_encoded(self) -> bool {
        self.encoding != Encoding::Linear
    }

    /// A colour of this space as scene-linear Rec. 709. Computed in 64 bits; whites become white, adapted
    /// as Bradford has it, and what lies outside of the primaries of Rec. 709 has components below 0.
    pub fn to_linear_rec709(self, color: [f64; 3]) -> [f64; 3] {
        let linear = color.map(|x| self.decoded(x));
        match self.gamut {
            None => linear,
            Some(gamut) => applied(&gamut.to_rec709(), linear),
        }
    }

    fn decoded(self, x: f64) -> f64 {
        match self.encoding {
            Encoding::Linear => x,
            Encoding::Srgb if x <= 0.04045 => x / 12.92,
            Encoding::Srgb => ((x + 0.055) / 1.055).powf(2.4),
            Encoding::Power(exponent) => x.max(0.0).powf(exponent),
        }
    }
}

/// From XYZ to the responses of cones that Bradford scales.
const BRADFORD: Matrix =
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];

impl Gamut {
    fn to_rec709(&self) -> Matrix {
        let (own, ours) =
            (applied(&BRADFORD, xyz(self.white)), applied(&BRADFORD, xyz(REC_709.white)));
        let mut scaled = [[0.0; 3]; 3];
        for at in 0..3 {
            scaled[at][at] = ours[at] / own[at];
        }
        let adaptation = product(&inverse(&BRADFORD), &product(&scaled, &BRADFORD));
        product(&inverse(&REC_709.to_xyz()), &product(&adaptation, &self.to_xyz()))
    }

    /// The primaries, scaled so that they sum to white.
    fn to_xyz(&self) -> Matrix {
        let columns = transposed(&self.primaries.map(xyz));
        let scale = applied(&inverse(&columns), xyz(self.white));
        columns.map(|row| std::array::from_fn(|at| row[at] * scale[at]))
    }
}

/// A chromaticity as a colour of luminance 1.
fn xyz([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

fn applied(matrix: &Matrix, color: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * color[0] + row[1] * color[1] + row[2] * color[2])
}

fn transposed(matrix: &Matrix) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[column][row]))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    transposed(&columns.map(|column| applied(a, column)))
}

/// By cofactors: none of the matrices here is near to singular.
fn inverse(matrix: &Matrix) -> Matrix {
    let minor = |row: usize, column: usize| {
        let at = |r: usize, c: usize| matrix[(row + r) % 3][(column + c) % 3];
        at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)
    };
    let determinant = (0..3).map(|at| matrix[0][at] * minor(0, at)).sum::<f64>();
    std::array::from_fn(|row| std::array::from_fn(|column| minor(column, row) / determinant))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Colours as MaterialX 1.39.5 converts them: (0.5, 0.25, 0.75) and (0.02, 0.9, 0.4).
    const MATERIALX: [(&str, [[f64; 3]; 2]); 14] = [
        (
            "srgb_texture",
            [[0.214041129, 0.0508760922, 0.522521675], [0.00154798757, 0.787412345, 0.132868379]],
        ),
        (
            "g22_rec709",
            [[0.217637643, 0.0473661423, 0.531049311], [0.000182921998, 0.793110073, 0.133208513]],
        ),
        (
            "g18_rec709",
            [[0.287174612, 0.0824692547, 0.595813394], [0.000874690188, 0.827249348, 0.192179903]],
        ),
        (
            "rec709_display",
            [[0.189464569, 0.0358968191, 0.501356959], [8.36511826e-05, 0.776572347, 0.110903151]],
        ),
        (
            "acescg",
            [[0.634633183, 0.212162256, 0.820485234], [-0.55881542, 1.0199002, 0.344636619]],
        ),
        (
            "lin_ap1",
            [[0.634633183, 0.212162256, 0.820485234], [-0.55881542, 1.0199002, 0.344636619]],
        ),
        (
            "g22_ap1",
            [[0.297416747, 0.0200854167, 0.600952268], [-0.503928423, 0.903355062, 0.0512946844]],
        ),
        (
            "adobergb",
            [[0.285610706, 0.047417473, 0.551935673], [-0.315709591, 0.79317534, 0.104976296]],
        ),
        (
            "lin_adobergb",
            [[0.59958899, 0.25, 0.771464527], [-0.330553263, 0.899999976, 0.378535539]],
        ),
        (
            "srgb_displayp3",
            [[0.250741869, 0.04401353, 0.565674543], [-0.175216496, 0.820464969, 0.0839690641]],
        ),
        (
            "lin_displayp3",
            [[0.556232512, 0.239485234, 0.794234276], [-0.177938402, 0.937011838, 0.368139595]],
        ),
        ("lin_srgb", [[0.5, 0.25, 0.75], [0.0199999996, 0.899999976, 0.400000006]]),
        ("lin_rec709", [[0.5, 0.25, 0.75], [0.0199999996, 0.899999976, 0.400000006]]),
        (
            "srgb",
            [[0.214041129, 0.0508760922, 0.522521675], [0.00154798757, 0.787412345, 0.132868379]],
        ),
    ];

    #[test]
    fn colors_are_those_of_materialx() {
        for (name, expected) in MATERIALX {
            let space = ColorSpace::find(name).unwrap();
            for (color, expected) in [[0.5, 0.25, 0.75], [0.02, 0.9, 0.4]].iter().zip(expected) {
                let converted = space.to_linear_rec709(*color);
                for (ours, theirs) in converted.iter().zip(expected) {
                    // Its matrices are rounded to six digits, and it computes in 32 bits.
                    assert!(
                        (ours - theirs).abs() < 1e-5,
                        "{name}: {converted:?}, not {expected:?}"
                    );
                }
            }
        }
        // Of `g18_ap1` its generator has no transform, and leaves such colours as they are; here it is what
        // its name says.
        let [name, light] = ["g18_ap1", "lin_ap1"].map(|name| ColorSpace::find(name).unwrap());
        let color = [0.5, 0.25, 0.75];
        let decoded = color.map(|x: f64| x.powf(1.8));
        assert_eq!(name.to_linear_rec709(color), light.to_linear_rec709(decoded));
        assert_eq!(MATERIALX.len() + 1, ColorSpace::ALL.len());
    }

    #[test]
    fn white_stays_white_and_black_black() {
        for space in ColorSpace::ALL {
            for x in [0.0, 1.0] {
                let converted = space.to_linear_rec709([x; 3]);
                assert!(
                    converted.iter().all(|it| (it - x).abs() < 1e-14),
                    "{space:?}: {converted:?}"
                );
            }
        }
    }

    #[test]
    fn inverses_undo() {
        let both = product(&BRADFORD, &inverse(&BRADFORD));
        for (row, values) in both.iter().enumerate() {
            for (column, value) in values.iter().enumerate() {
                let expected = f64::from(u8::from(row == column));
                assert!((value - expected).abs() < 1e-15, "{both:?}");
            }
        }
    }
}
