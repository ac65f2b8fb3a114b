use std::f64::consts::PI;

use crate::emit::functions::conventions::atan2_or_zero;

/// The 32-bit number nearest to pi lies above it.
const ROUNDED_PI: f64 = PI as f32 as f64;

node! {
    /// Angle of the point (x, y) from the x axis, in radians, counterclockwise; 0 for the origin.
    arc_tangent2 in arithmetic,
    source "",
    inputs {
        /// Second coordinate.
        y: scalar = 0.0;
        /// First coordinate.
        x: scalar = 1.0;
    }
    outputs {
        /// The angle.
        result: scalar, in -ROUNDED_PI..=ROUNDED_PI;
    }
    body |e, i| Outputs { result: atan2_or_zero(i.y, i.x) }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn all_round_the_circle() {
        for k in -16..=16 {
            let angle = f64::from(k) * 0.19;
            let (y, x) = (angle.sin() as f32 * 3.0, angle.cos() as f32 * 3.0);
            let exact = f64::from(y).atan2(f64::from(x));
            assert_close(&numbers!(y = y, x = x => result), &[exact], 4e-7, 0.0);
        }
    }

    #[test]
    fn axes_and_origin() {
        use std::f64::consts::{FRAC_PI_2, PI};
        for (y, x, exact) in [
            (0.0, 1.0, 0.0),
            (1.0, 0.0, FRAC_PI_2),
            (-1.0, 0.0, -FRAC_PI_2),
            (0.0, -1.0, PI),
            (f32::MAX, f32::MIN, 0.75 * PI),
            (1e-45, 1e-45, 0.25 * PI),
        ] {
            assert_close(&numbers!(y = y, x = x => result), &[exact], 3e-7, 0.0);
        }
        for (y, x) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
            assert_eq!(number!(y = y, x = x => result), 0.0);
        }
    }
}
