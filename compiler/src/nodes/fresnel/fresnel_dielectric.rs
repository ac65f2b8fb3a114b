use crate::emit::{Emit, Mask, Real};
use crate::nodes::finite::UNIT;

node! {
    /// Share of unpolarised light that a smooth boundary between two dielectrics reflects: the mean
    /// of `rs^2` and `rp^2`. Total internal reflection gives 1, equal indices give 0.
    ///
    /// With `c` the cosine, `D = (n2^2 - n1^2) / n1^2` and `g^2 = D + c^2`:
    /// `rs = D / (g + c)^2` and `rp / rs = (c g - s^2) / (c g + s^2)`, `s^2 = 1 - c^2`. No angle is
    /// computed, and nothing cancels where the indices nearly match; up to the critical angle `g^2` is a
    /// difference of exact products, so that what passes has a bounded relative error. An index of 0 or
    /// less counts as 1, others are held within 1/64 and 100.
    fresnel_dielectric in fresnel,
    source "Born and Wolf, Principles of Optics, 1.5",
    inputs {
        /// Index of refraction on the side the light comes from.
        ior_in: scalar = 1.0, in 0.0..=100.0, soft 1.0..=2.5;
        /// Index of refraction beyond the boundary.
        ior_out: scalar = 1.5, in 0.0..=100.0, soft 1.0..=2.5;
        /// Cosine between the light's direction and the normal, clamped to 0..1.
        cosine: scalar = 1.0, in -1.0..=1.0;
    }
    outputs {
        /// Share reflected.
        reflectance: scalar, in UNIT;
    }
    body |e, i| Outputs { reflectance: reflectance(e, index(e, i.ior_in), index(e, i.ior_out), i.cosine) }
}

/// An index of refraction as it is read: 0, less and NaN mean unset and count as 1.
#[inline(always)]
pub fn index<E: Emit>(e: E, ior: E::Real) -> E::Real {
    let one = e.real(1.0);
    ior.greater(e.real(0.0)).select(ior.clamp_to(e.real(1.0 / 64.0), e.real(100.0)), one)
}

/// Light at a boundary between media with indices n1 and n2, in units of n1.
pub struct Boundary<R: Real> {
    /// Cosine of the incident direction, 0 to 1.
    pub cosine: R,
    /// `1 - cosine^2`.
    pub sine_squared: R,
    /// `(n2^2 - n1^2) / n1^2`.
    pub excess: R,
    /// Cosine of the refracted direction times `n2 / n1`; 0 under total reflection.
    pub transmitted: R,
    /// Whether n1 equals n2: no boundary at all.
    pub matched: R::Mask,
    /// Whether all light is reflected.
    pub total: R::Mask,
}

/// The quantities from which reflectance and refracted direction follow.
#[inline(always)]
pub fn boundary<E: Emit>(e: E, n1: E::Real, n2: E::Real, cosine: E::Real) -> Boundary<E::Real> {
    let one = e.real(1.0);
    let cosine = cosine.saturate();
    let sine_squared = (one - cosine) * (one + cosine);
    let excess = (n2 - n1) * (n2 + n1) / (n1 * n1);
    let squared = transmitted_squared(n1, n2, cosine);
    let matched = n1.equal(n2);
    Boundary {
        cosine,
        sine_squared,
        excess,
        transmitted: squared.maximum(e.real(0.0)).sqrt(),
        matched,
        total: squared.less_equal(e.real(0.0)) & !matched,
    }
}

/// `(n2^2 - n1^2 + n1^2 c^2) / n1^2`, in which all digits cancel near the critical angle.
///
/// Each product is taken with its rounding error (Dekker 1971, with a fused product), the first sum too (Knuth's
/// two-sum), and near the critical angle the second is exact (Sterbenz): what passes has a bounded relative
/// error up to the last cosine, and whether anything passes is known to 2^-48 of the squared index.
#[inline(always)]
fn transmitted_squared<R: Real>(n1: R, n2: R, cosine: R) -> R {
    let (beyond, beyond_low) = product(n2, n2);
    let (before, before_low) = product(n1, n1);
    let (normal, normal_low) = product(n1, cosine);
    let (along, along_low) = product(normal, normal);
    let sum = beyond + along;
    let part = sum - beyond;
    let lost = (beyond - (sum - part)) + (along - part);
    let low = (beyond_low + along_low) + (lost - before_low);
    let low = (normal * 2.0).mul_add(normal_low, low);
    ((sum - before) + low) / before
}

/// A product and the error of its rounding, exactly.
#[inline(always)]
fn product<R: Real>(a: R, b: R) -> (R, R) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}

/// Share of light reflected, for indices as [`index`] yields them.
#[inline(always)]
pub fn reflectance<E: Emit>(e: E, n1: E::Real, n2: E::Real, cosine: E::Real) -> E::Real {
    let b = boundary(e, n1, n2, cosine);
    let sum = b.transmitted + b.cosine;
    let rs = b.excess / (sum * sum);
    let product = b.cosine * b.transmitted;
    let rp_over_rs = (product - b.sine_squared) / (product + b.sine_squared);
    let mean = rs * rs * rp_over_rs.mul_add(rp_over_rs, e.real(1.0)) * 0.5;
    let partial = b.total.select(e.real(1.0), mean.saturate());
    b.matched.select(e.real(0.0), partial)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn reflectance(ior_in: f32, ior_out: f32, cosine: f32) -> f32 {
        number!(ior_in = ior_in, ior_out = ior_out, cosine = cosine => reflectance)
    }

    #[test]
    fn known_values() {
        for (n1, n2, cosine, expected) in [
            (1.0, 1.5, 1.0, 0.04),
            (1.0, 1.5, 0.866_025_4, 0.041522625975821535),
            (1.0, 1.5, 0.707_106_77, 0.05023991101223593),
            (1.0, 1.5, 0.5, 0.08918671280221278),
            (1.0, 1.5, 0.1, 0.5715925),
            (1.0, 1.5, 1e-8, 0.9999999418622345),
            (1.0, 1.33, 1.0, 0.0200593),
            (1.0, 1.33, 0.5, 0.0591256),
            (1.33, 1.5, 0.6, 0.00997535365902181),
            (1.0, 2.42, 1.0, 0.17239492493416778),
            (1.5, 1.0, 0.866_025_4, 0.055190167295375896),
        ] {
            assert_close(&[reflectance(n1, n2, cosine)], &[expected], 4e-6, 0.0);
        }
    }

    #[test]
    fn limits_are_exact() {
        for cosine in [0.0, 1e-45, 0.5, 1.0] {
            assert_eq!(reflectance(1.5, 1.5, cosine), 0.0, "equal indices at {cosine}");
        }
        assert_eq!(reflectance(1.0, 1.5, 0.0), 1.0);
        assert_eq!(reflectance(1.5, 1.0, 0.5), 1.0);
        assert_eq!(reflectance(1.5, 1.0, 0.0), 1.0);
        assert_eq!(reflectance(1.0, 1.5, -0.3), 1.0);
        assert_eq!(reflectance(1.0, 1.5, f32::NAN), 1.0);
        assert_eq!(reflectance(0.0, 1.5, 1.0), reflectance(1.0, 1.5, 1.0));
        assert_eq!(reflectance(-2.0, f32::NAN, 1.0), 0.0);
    }

    /// What passes close to the critical angle grows as the root of the distance from it: in 64 bits, from the
    /// same 32-bit inputs. A form without exact products lost 7 % of it for glass, half for nearly equal indices.
    #[test]
    fn what_passes_next_to_the_critical_angle_is_accurate() {
        let mut worst = 0.0_f64;
        for (n1, n2) in [(1.5_f32, 1.0_f32), (1.33, 1.0), (2.42, 1.5), (100.0, 1.0), (1.000_1, 1.0)]
        {
            let (a, b) = (f64::from(n1), f64::from(n2));
            let critical = ((a - b) * (a + b)).sqrt() / a;
            let mut cosine = critical as f32;
            for _ in 0..40 {
                cosine = cosine.next_up();
                let c = f64::from(cosine);
                let squared = (b * b - a * a) + a * c * (a * c);
                assert!(squared > 0.0, "{n1} {n2} {cosine}");
                let g = squared.sqrt() / a;
                let (rs, ratio) = ((c - g) / (c + g), b / a);
                let rp = (ratio * ratio * c - g) / (ratio * ratio * c + g);
                let passes = 1.0 - (rs * rs + rp * rp) / 2.0;
                let found = 1.0 - f64::from(reflectance(n1, n2, cosine));
                // What 1 less a number close to 1 can tell.
                let error = (found - passes).abs() - f64::from(f32::EPSILON);
                worst = worst.max(error / passes);
            }
        }
        assert!(worst < 2e-4, "{worst}");
    }

    /// The textbook form in 64 bits, from the same inputs.
    fn textbook(n1: f64, n2: f64, cosine: f64) -> f64 {
        let sine = n1 / n2 * ((1.0 - cosine) * (1.0 + cosine)).sqrt();
        if sine >= 1.0 {
            return 1.0;
        }
        let refracted = ((1.0 - sine) * (1.0 + sine)).sqrt();
        let rs = (n1 * cosine - n2 * refracted) / (n1 * cosine + n2 * refracted);
        let rp = (n2 * cosine - n1 * refracted) / (n2 * cosine + n1 * refracted);
        (rs * rs + rp * rp) / 2.0
    }

    #[test]
    fn nearly_equal_indices_do_not_cancel() {
        for n1 in [1.0, 1.5] {
            for cosine in [1.0, 0.8, 0.3, 1e-2] {
                let n2 = f32::next_up(n1);
                let exact = textbook(n1.into(), n2.into(), cosine.into());
                assert_close(&[reflectance(n1, n2, cosine)], &[exact], 1e-5, 0.0);
            }
        }
    }

    #[test]
    fn agrees_with_the_textbook_over_all_indices() {
        for n1 in [0.02, 0.5, 1.0, 1.33, 2.42, 100.0] {
            for n2 in [0.02, 0.6, 1.0, 1.5, 4.0, 100.0_f32] {
                for k in 0..=64 {
                    let cosine = k as f32 / 64.0;
                    let exact = textbook(n1.into(), n2.into(), cosine.into());
                    if n1 != n2 {
                        assert_close(&[reflectance(n1, n2, cosine)], &[exact], 2e-5, 0.0);
                    }
                }
            }
        }
    }

    #[test]
    fn the_critical_angle_is_met_from_both_sides() {
        let critical = 0.745_356_f32;
        // The square of this cosine is 5 / 9 to 2 parts in 10^8: its two neighbours lie on either side.
        assert_eq!(reflectance(1.5, 1.0, critical.next_down().next_down()), 1.0);
        let just_inside = reflectance(1.5, 1.0, critical.next_up().next_up());
        assert!(just_inside > 0.99 && just_inside < 1.0, "{just_inside}");
    }
}
