//! Which pixels a footprint covers.

/// Most probes along the longer axis of a footprint. A longer one is blurred across.
const MOST_PROBES: f64 = 16.0;

/// Probes that cover a footprint, side by side along its longer axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Probes {
    /// How many, at least one.
    pub count: u32,
    /// From one to the next, in surface coordinates.
    pub step: [f64; 2],
    /// How often a probe halves the picture: a level of detail, from 0.
    pub level: f64,
}

impl Probes {
    /// Those of the ellipse with these two conjugate half-axes, each the change of surface coordinates
    /// across a pixel, on a picture of so many pixels. Numbers that are not finite count as the largest
    /// there are, NaN as 0.
    ///
    /// The axes of the ellipse are those of the matrix of both vectors: its squared singular values are
    /// m ± sqrt(d^2 + q^2), and the smaller is |determinant| / larger, which does not cancel.
    pub fn of(footprint: [[f32; 2]; 2], [width, height]: [u32; 2]) -> Self {
        let finite = |x: f32| {
            let x = if x.is_nan() { 0.0 } else { x };
            f64::from(x.clamp(f32::MIN, f32::MAX))
        };
        let size = [f64::from(width), f64::from(height)];
        let [[ax, ay], [bx, by]] =
            footprint.map(|axis| [finite(axis[0]) * size[0], finite(axis[1]) * size[1]]);
        let (p, q, r) = (ax * ax + bx * bx, ax * ay + bx * by, ay * ay + by * by);
        let (mean, difference) = ((p + r) / 2.0, (p - r) / 2.0);
        let root = (difference * difference + q * q).sqrt();
        let major = (mean + root).sqrt();
        if major <= 1.0 {
            return Self { count: 1, step: [0.0; 2], level: 0.0 };
        }
        let minor = (ax * by - ay * bx).abs() / major;
        let across = minor.max(1.0).max(major / MOST_PROBES);
        // A round one takes one probe, whatever rounding made of its axes.
        let count = (major / across - 1e-6).ceil().clamp(1.0, MOST_PROBES);
        let direction = match difference >= 0.0 {
            true => [difference + root, q],
            false => [q, root - difference],
        };
        let length = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
        let along = if length > 0.0 { major / count / length } else { 0.0 };
        let step = [0, 1].map(|axis| direction[axis] * along / size[axis]);
        Self { count: count as u32, step, level: doublings(across) }
    }
}

/// The logarithm to base 2 of a number of at least 1, straight between powers of two: at most 0.09 too small,
/// and made of the bits alone, so that it is the same on every machine.
fn doublings(x: f64) -> f64 {
    let bits = x.to_bits();
    let whole = (bits >> 52) as f64 - 1023.0;
    let fraction = f64::from_bits(bits & ((1 << 52) - 1) | 1.0_f64.to_bits()) - 1.0;
    whole + fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-6
    }

    #[test]
    fn a_round_footprint_takes_one_probe_of_its_size() {
        let Probes { count, level, .. } = Probes::of([[0.25, 0.0], [0.0, 0.25]], [16, 16]);
        assert_eq!((count, level), (1, 2.0));
        let small = Probes::of([[0.01, 0.0], [0.0, 0.01]], [16, 16]);
        assert_eq!(small, Probes { count: 1, step: [0.0; 2], level: 0.0 });
    }

    #[test]
    fn a_long_footprint_takes_several_along_it() {
        let Probes { count, step, level } = Probes::of([[0.5, 0.0], [0.0, 0.0625]], [16, 16]);
        assert_eq!((count, level), (8, 0.0));
        assert!(close(step[0], 0.0625) && step[1] == 0.0, "{step:?}");
        // Either vector may be the longer one, and they need not be at right angles.
        let turned = Probes::of([[0.0, 0.0625], [0.5, 0.0]], [16, 16]);
        assert_eq!((turned.count, turned.level), (8, 0.0));
        let slanted = Probes::of([[0.25, 0.25], [0.25, 0.2499]], [16, 16]);
        assert_eq!(slanted.count, 8);
        assert!(close(slanted.step[0] / slanted.step[1], 1.0002), "{:?}", slanted.step);
    }

    #[test]
    fn too_long_a_footprint_is_blurred_across() {
        let Probes { count, step, level } = Probes::of([[4.0, 0.0], [0.0, 0.0]], [16, 16]);
        assert_eq!((count, level), (16, 2.0));
        assert!(close(step[0], 0.25));
    }

    #[test]
    fn hard_footprints_are_finite() {
        for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1e-45, -0.0, 0.0] {
            for y in [0.0, x, 1.0] {
                let Probes { count, step, level } = Probes::of([[x, y], [y, x]], [65_536, 3]);
                let finite = step.iter().all(|x| x.is_finite());
                assert!(
                    (1..=16).contains(&count) && finite && (0.0..1024.0).contains(&level),
                    "{x} {y}"
                );
            }
        }
    }

    #[test]
    fn doublings_are_exact_at_powers_of_two() {
        for power in 0..60 {
            assert_eq!(doublings(2.0_f64.powi(power)), f64::from(power));
        }
        assert!((doublings(3.0) - 3.0_f64.log2()).abs() < 0.09);
    }
}
