use crate::emit::functions::colors::{XYZ_TO_REC709, weighted};
use crate::emit::{Color, Mask, Real};

node! {
    /// Colour of light of one wavelength, by sums of Gaussians that fit the CIE 1931 colour
    /// matching functions to 0.02; black where the eye sees nothing. Spectral colours lie
    /// outside Rec. 709, so components below 0 are clipped and the colours are less pure than
    /// the light. The brightest, near 555 nm, has a luminance of 1 before clipping. Alpha is 1.
    wavelength_to_color in color,
    source "Wyman, Sloan and Shirley 2013, Simple Analytic Approximations to the CIE XYZ Color Matching Functions",
    inputs {
        /// Wavelength.
        wavelength: scalar = 555.0, in 0.0..=1e6, unit "nanometres", soft 380.0..=730.0;
    }
    outputs {
        /// The colour.
        color: color, in 0.0..=4.0;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let at = i.wavelength;
        let x = lobe(at, [1.056, 599.8, 37.9, 31.0]) + lobe(at, [0.362, 442.0, 16.0, 26.7]);
        let x = x + lobe(at, [-0.065, 501.1, 20.4, 26.2]);
        let y = lobe(at, [0.821, 568.8, 46.9, 40.5]) + lobe(at, [0.286, 530.9, 16.3, 31.1]);
        let z = lobe(at, [1.217, 437.0, 11.8, 36.0]) + lobe(at, [0.681, 459.0, 26.0, 13.8]);
        let color = weighted(Color { r: x, g: y, b: z, a: one }, &XYZ_TO_REC709);
        let most = e.real(4.0);
        let seen = Color {
            r: color.r.clamp_to(zero, most),
            g: color.g.clamp_to(zero, most),
            b: color.b.clamp_to(zero, most),
            a: one,
        };
        Outputs { color: seen }
    }
}

/// A Gaussian with its own width on either side: height, middle, and the widths below and
/// above.
#[inline(always)]
fn lobe<R: Real>(at: R, [height, middle, below, above]: [f64; 4]) -> R {
    let off = at - middle;
    let slope = off.less(at.same(0.0)).select(at.same(1.0 / below), at.same(1.0 / above));
    let t = off * slope;
    (t * t * -0.5).exp() * height
}

#[cfg(test)]
mod tests {
    #[test]
    fn goes_from_violet_over_green_to_red() {
        let at = |wavelength: f32| numbers!(wavelength = wavelength => color);
        let (blue, green, red) = (at(450.0), at(530.0), at(640.0));
        assert!(blue[2] > 1.0 && blue[0] < 0.5 && blue[1] == 0.0, "{blue:?}");
        assert!(green[1] > 1.0 && green[0] == 0.0, "{green:?}");
        assert!(red[0] > 1.0 && red[1] < 0.1 && red[2] < 0.01, "{red:?}");
    }

    #[test]
    fn nothing_is_seen_outside() {
        for wavelength in [0.0, 200.0, 1000.0, 1e6] {
            assert!(numbers!(wavelength = wavelength => color)[..3].iter().all(|&x| x < 1e-6));
        }
    }

    #[test]
    fn fits_the_matching_functions() {
        // Rec. 709 of CIE 1931, 580 nm: x 0.9163, y 0.8700, z 0.0017.
        let yellow = numbers!(wavelength = 580.0 => color);
        let red = 3.240_97 * 0.916_3 - 1.537_38 * 0.87 - 0.498_61 * 0.001_7;
        let green = -0.969_24 * 0.916_3 + 1.875_97 * 0.87 + 0.041_56 * 0.001_7;
        crate::nodes::harness::assert_close(&yellow[..3], &[red, green, 0.0], 0.06, 0.0);
    }
}
