use crate::emit::{Color, Mask, Real};
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_dielectric::{Boundary, boundary, index};

node! {
    /// Share of light that a surface under a clear film reflects, for three wavelengths: what bounces
    /// between both boundaries of the film is summed up with its phase (Airy), so colours of soap and
    /// oil. With the amplitudes `r` and `r'` of the boundaries and half the phase
    /// `d = 2 pi ior_film thickness cos / wavelength`, for each polarisation:
    /// `((r + r')^2 - 4 r r' sin^2 d) / ((1 + r r')^2 - 4 r r' sin^2 d)`.
    ///
    /// In this form nothing is lost where the film is thin, and at thickness 0 it is
    /// `fresnel_dielectric` of what the film lies on. Amplitudes come from differences of indices, not of
    /// products, as there. Three wavelengths stand for red, green and blue, so that colours of films
    /// above some thousand nanometres do not wash out as they do for the eye. Where film or ground
    /// reflect totally, all light is reflected.
    thin_film in fresnel,
    source "Born and Wolf, Principles of Optics, 7.6; compare Belcour and Barla 2017, for the eye's response",
    inputs {
        /// Cosine between the light's direction and the normal, clamped to 0..1.
        cosine: scalar = 1.0, in -1.0..=1.0;
        /// Thickness of the film.
        thickness: scalar = 400.0, in 0.0..=10000.0, unit "nanometres", soft 100.0..=1000.0;
        /// Index of refraction of the film.
        ior_film: scalar = 1.33, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction of what it lies on: 1 for a soap bubble.
        ior_base: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction of what surrounds it.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
        /// Wavelengths of red, green and blue.
        wavelengths: vector = [612.0, 549.0, 464.0], in 100.0..=10000.0, unit "nanometres", soft 380.0..=730.0;
    }
    outputs {
        /// Share reflected for each colour; alpha is 1.
        color: color, in UNIT;
    }
    body |e, i| {
        let (outside, film, base) = (index(e, i.ior_in), index(e, i.ior_film), index(e, i.ior_base));
        let upper = boundary(e, outside, film, i.cosine);
        let cosine_film = upper.transmitted * outside / film;
        let lower = boundary(e, film, base, cosine_film);
        let amplitudes = Amplitudes::of(&upper, &lower);
        // In turns of pi, so that a sine of many turns keeps its accuracy.
        let path = film * i.thickness.maximum(e.real(0.0)) * cosine_film * 2.0;
        let total = upper.total | lower.total;
        let color = Color {
            r: amplitudes.reflectance(total, path, i.wavelengths.x),
            g: amplitudes.reflectance(total, path, i.wavelengths.y),
            b: amplitudes.reflectance(total, path, i.wavelengths.z),
            a: e.real(1.0),
        };
        Outputs { color }
    }
}

/// For each polarisation: the squared sum of both amplitudes, the squared sum of 1 and their product, and four
/// times that product.
struct Amplitudes<R: Real> {
    sums: [R; 2],
    wholes: [R; 2],
    products: [R; 2],
}

impl<R: Real> Amplitudes<R> {
    #[inline(always)]
    fn of(upper: &Boundary<R>, lower: &Boundary<R>) -> Self {
        let (first, second) = (of_boundary(upper), of_boundary(lower));
        let one = first[0].same(1.0);
        let sums = [first[0] + second[0], first[1] + second[1]];
        let products = [first[0] * second[0], first[1] * second[1]];
        Self {
            sums: [sums[0] * sums[0], sums[1] * sums[1]],
            wholes: [
                (one + products[0]) * (one + products[0]),
                (one + products[1]) * (one + products[1]),
            ],
            products: [products[0] * 4.0, products[1] * 4.0],
        }
    }

    #[inline(always)]
    fn reflectance(&self, total: R::Mask, path: R, wavelength: R) -> R {
        let (zero, one) = (path.same(0.0), path.same(1.0));
        let turns = path.divide_or_zero(wavelength);
        let turns = turns - turns.floor();
        let sine = (turns * std::f64::consts::PI).sin();
        let squared = sine * sine;
        let mut sum = zero;
        for polarisation in 0..2 {
            let back = self.products[polarisation] * squared;
            let below = self.wholes[polarisation] - back;
            sum = sum + (self.sums[polarisation] - back).divide_or_zero(below).saturate();
        }
        total.select(one, (sum * 0.5).saturate())
    }
}

/// The amplitudes `rs` and `rp` of a boundary.
#[inline(always)]
fn of_boundary<R: Real>(boundary: &Boundary<R>) -> [R; 2] {
    let zero = boundary.cosine.same(0.0);
    let sum = boundary.transmitted + boundary.cosine;
    let rs = -(boundary.excess / (sum * sum));
    let product = boundary.cosine * boundary.transmitted;
    let rp = rs * ((product - boundary.sine_squared) / (product + boundary.sine_squared));
    [boundary.matched.select(zero, rs), boundary.matched.select(zero, rp)]
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    /// Fresnel's reflectance without a film.
    fn bare(n: f64, cosine: f64) -> f64 {
        let transmitted = (1.0 - (1.0 - cosine * cosine) / (n * n)).sqrt();
        let rs = (cosine - n * transmitted) / (cosine + n * transmitted);
        let rp = (n * cosine - transmitted) / (n * cosine + transmitted);
        (rs * rs + rp * rp) / 2.0
    }

    #[test]
    fn a_film_of_no_thickness_is_not_there() {
        for cosine in [0.05_f32, 0.3, 0.7, 1.0] {
            let color = numbers!(cosine = cosine, thickness = 0.0 => color);
            let expected = bare(1.5, cosine.into());
            assert_close(&color, &[expected, expected, expected, 1.0], 1e-5, 0.0);
        }
    }

    #[test]
    fn a_quarter_wave_of_the_mean_index_reflects_nothing_and_a_half_wave_is_not_there() {
        let film = 1.5_f32.sqrt();
        let wave = 500.0 / film;
        let wavelengths = [500.0; 3];
        let quarter =
            numbers!(thickness = wave / 4.0, ior_film = film, wavelengths = wavelengths => color);
        assert!(quarter[0] < 1e-9, "{quarter:?}");
        let half =
            numbers!(thickness = wave / 2.0, ior_film = film, wavelengths = wavelengths => color);
        assert_close(&half[..1], &[0.04], 1e-4, 0.0);
    }

    /// A soap film in air, a quarter wave thick: `((1 - n^2) / (1 + n^2))^2`.
    #[test]
    fn a_soap_film_is_black_where_it_is_thin_and_bright_at_a_quarter_wave() {
        let at = |thickness: f32| number!(thickness = thickness, ior_base = 1.0, wavelengths = [532.0; 3] => color);
        // Both sides of the film cancel to a rounding of each.
        assert!(at(0.0) < 1e-14);
        let n = f64::from(1.33_f32);
        let expected = ((1.0 - n * n) / (1.0 + n * n)).powi(2);
        assert_close(&[at(100.0)], &[expected], 1e-5, 0.0);
        // Thin films reflect as the square of their thickness.
        assert_close(&[at(1.0) / at(0.1)], &[100.0], 1e-3, 0.0);
    }

    #[test]
    fn total_reflection_is_total() {
        let color = numbers!(cosine = 0.3, ior_in = 1.5, ior_base = 1.0 => color);
        assert_eq!(color, [1.0; 4]);
        assert_eq!(numbers!(cosine = 0.0 => color), [1.0; 4]);
    }
}
