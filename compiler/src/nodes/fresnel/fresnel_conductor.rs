use crate::emit::{Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Share of unpolarised light that a metal reflects in air, per component: the mean of Fresnel's
    /// reflectances for the complex index `ior + i extinction`.
    ///
    /// With `a + i b` the root of `(ior + i extinction)^2 - s`, `s` being the squared sine and `c` the cosine:
    /// `rs = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)` and
    /// `rp = rs ((a c - s)^2 + b^2 c^2) / ((a c + s)^2 + b^2 c^2)`: sums of squares. Of `a` and `b` the larger comes
    /// from a sum, the other from the product of both. The square's real part is
    /// `(ior - 1) (ior + 1) - extinction^2 + c^2` and `a - c` is `(a^2 - c^2) / (a + c)`, so that nothing cancels where
    /// the metal is next to air, however grazing the ray; where it is air nothing is reflected. Without extinction it
    /// is `fresnel_dielectric` from air. For a metal under a clear medium divide both by the medium's index.
    fresnel_conductor in fresnel per component,
    source "Born and Wolf, Principles of Optics, 14.2",
    inputs {
        /// Index of refraction.
        ior: generic = 0.2, in 0.0..=1e6, soft 0.1..=5.0;
        /// Extinction coefficient.
        extinction: generic = 3.9, in 0.0..=1e6, soft 0.0..=10.0;
        /// Cosine between the light's direction and the normal, clamped to 0..1.
        cosine: scalar = 1.0, in -1.0..=1.0;
    }
    outputs {
        /// Share reflected.
        reflectance: generic, in UNIT;
    }
    body |e, i| reflectance(i.ior, i.extinction, i.cosine.saturate())
}

/// Of a cosine from 0 to 1.
#[inline(always)]
pub fn reflectance<R: Real>(n: R, k: R, cosine: R) -> R {
    let (zero, one) = (n.same(0.0), n.same(1.0));
    let sine_squared = (one - cosine) * (one + cosine);
    // (n + i k)^2 - 1 = excess + 2 i n k.
    let excess = (-k).mul_add(k, (n - one) * (n + one));
    let real = cosine.mul_add(cosine, excess);
    let product = n * k;
    // Of the larger part, so that no square vanishes.
    let (real_size, imaginary) = (real.absolute(), product * 2.0);
    let most = real_size.maximum(imaginary);
    let share = real_size.minimum(imaginary).divide_or_zero(most);
    let size = most * share.mul_add(share, one).sqrt();
    let large = (size + real_size) * 0.5;
    let small = product * product.divide_or_zero(large);
    let negative = real.less(zero);
    let (a_squared, b_squared) = (negative.select(small, large), negative.select(large, small));
    let a = a_squared.sqrt();
    let more = a + cosine;
    // a^2 - c^2 = excess + b^2.
    let less = (excess + b_squared).divide_or_zero(more);
    let rs = less.mul_add(less, b_squared) / more.mul_add(more, b_squared);
    let along = a * cosine;
    let (less, more) = (along - sine_squared, along + sine_squared);
    let rest = b_squared * cosine * cosine;
    let below = more.mul_add(more, rest);
    let ratio = below.equal(zero).select(one, less.mul_add(less, rest) / below);
    let air = n.equal(one) & k.equal(zero);
    air.select(zero, (rs * (one + ratio) * 0.5).saturate())
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn at(ior: f32, extinction: f32, cosine: f32) -> f32 {
        number!(ior = ior, extinction = extinction, cosine = cosine => reflectance)
    }

    #[test]
    fn known_values() {
        for (n, k, cosine, expected) in [
            (0.2, 3.9, 1.0, 0.9519519519519519),
            (0.2, 3.9, 0.8, 0.9511086572819465),
            (0.2, 3.9, std::f32::consts::FRAC_1_SQRT_2, 0.9500432),
            (0.2, 3.9, 0.5, 0.945882),
            (0.2, 3.9, 0.1, 0.9628965),
            (0.14, 4.0, 0.5, 0.963255253235214),
            (1.0, 1e5, 0.7, 0.9999999995742858),
            (1e-8, 4.0, 0.7, 0.9999999975368007),
            (1.5, 1e-9, 0.7, 0.050916935590777444),
        ] {
            assert_close(&[at(n, k, cosine)], &[expected], 1e-6, 0.0);
        }
    }

    #[test]
    fn without_extinction_it_is_a_dielectric() {
        use crate::values::Literal;
        let dielectric = crate::nodes::fresnel::fresnel_dielectric::definition();
        for ior in [1.0_f32, 1.0_f32.next_up(), 1.001, 1.33, 1.5, 2.42] {
            for cosine in [0.0, 1e-45_f32, 1e-20, 1e-8, 1e-3, 0.1, 0.5, 0.9, 1.0] {
                let given =
                    [("ior_out", Literal::Scalar(ior)), ("cosine", Literal::Scalar(cosine))];
                let expected =
                    crate::nodes::harness::numbers(&dielectric, &given, "reflectance")[0];
                assert_close(&[at(ior, 0.0, cosine)], &[expected.into()], 4e-6, 0.0);
            }
        }
    }

    #[test]
    fn the_ends_are_defined() {
        assert_eq!(at(0.2, 3.9, 0.0), 1.0);
        assert_eq!(at(0.0, 0.0, 1.0), 1.0);
        assert_eq!(at(0.0, 0.0, 0.0), 1.0);
        assert_eq!(at(1.0, 0.0, 0.5), 0.0);
        assert!(at(1e6, 1e6, 0.5) > 0.999_99);
    }
}
