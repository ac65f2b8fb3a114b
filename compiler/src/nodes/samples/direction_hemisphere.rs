use std::f64::consts::FRAC_1_PI;

use crate::emit::Real;
use crate::emit::functions::conventions::sqrt_or_zero;
use crate::nodes::finite::UNIT;
use crate::nodes::samples::direction_cone::round_axis;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// A direction in the hemisphere over a surface. Spread by the cosine, as light that a matte surface gathers
    /// counts, its height is `sqrt(1 - u)`: a mean over it needs no further weight. Spread uniformly over the
    /// solid angle, its height is `1 - u`.
    direction_hemisphere in samples,
    source "Malley 1988; Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed., A.5",
    inputs {
        /// How they are spread.
        spread: choice = 0, of ["cosine", "uniform"];
        /// The normal of the surface, of any length.
        normal: vector = state(Field::Normal);
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// The direction, unit length.
        direction: vector, in -1.0..=1.0;
        /// How densely such directions lie there, per steradian: `cos / pi`, or `1 / (2 pi)`.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let u = i.u.saturate();
        // 1 - sqrt(1 - u), whose digits the difference would lose for a small u.
        let height = match i.spread {
            0 => u / (e.real(1.0) + sqrt_or_zero(e.real(1.0) - u)),
            _ => u,
        };
        let cosine = (e.real(1.0) - height).saturate();
        Outputs {
            direction: round_axis(e, i.normal, height, i.v),
            density: match i.spread {
                0 => cosine * FRAC_1_PI,
                _ => e.real(FRAC_1_PI * 0.5),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    const UP: [f32; 3] = [0.0, 0.0, 1.0];

    #[test]
    fn heights_are_spread_as_said() {
        for u in [0.0_f32, 1e-7, 0.25, 0.75, 1.0] {
            let exact = f64::from(u);
            for (spread, height) in [(0, (1.0 - exact).sqrt()), (1, 1.0 - exact)] {
                let to = numbers!(spread = spread, normal = UP, u = u, v = 0.0 => direction);
                let expected = [(1.0 - height * height).sqrt(), 0.0, height];
                assert_close(&to, &expected, 1e-6, 1e-7);
                let density = number!(spread = spread, normal = UP, u = u => density);
                let due = if spread == 0 { height } else { 0.5 } / std::f64::consts::PI;
                assert_close(&[density], &[due], 1e-6, 1e-7);
            }
        }
    }

    #[test]
    fn it_stands_over_any_normal() {
        let normal = [-0.48, 0.6, -0.64];
        for at in 0..64 {
            let (u, v) = ((at % 8) as f32 / 8.0, (at / 8) as f32 / 8.0);
            let to = numbers!(normal = normal, u = u, v = v => direction);
            let cosine: f32 = to.iter().zip(normal).map(|(a, b)| a * b).sum();
            assert!((cosine - (1.0 - u).sqrt()).abs() < 1e-6, "{cosine} {u}");
        }
    }
}
