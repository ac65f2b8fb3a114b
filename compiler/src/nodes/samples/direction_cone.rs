use std::f64::consts::{PI, TAU};

use crate::emit::functions::conventions::{clamp_finite, sqrt_or_zero};
use crate::emit::functions::frames::Frame;
use crate::emit::{Emit, Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::{NOT_NEGATIVE, state};
use crate::state::Field;

node! {
    /// A direction in a cone round an axis, evenly spread over its solid angle: `1 - cos = u k` with
    /// `k = 1 - cos(angle)`. Reckoned as `k = 2 sin^2(angle / 2)` and `sin^2 = h (2 - h)`, `h = u k`, a narrow
    /// cone keeps all its digits, where the difference of cosines has none below a thousandth of a radian.
    direction_cone in samples,
    source "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed., A.5.4",
    inputs {
        /// Axis of the cone, of any length.
        axis: vector = state(Field::Normal);
        /// Angle between the axis and the side of the cone; pi is the whole sphere.
        angle: scalar = 0.5, in 0.0..=3.15, unit "radians";
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// The direction, unit length.
        direction: vector, in -1.0..=1.0;
        /// How densely such directions lie, per steradian: `1 / (2 pi k)`; 0 for a cone without width.
        density: scalar, in NOT_NEGATIVE;
    }
    body |e, i| {
        let half = (i.angle.clamp_to(e.real(0.0), e.real(PI)) * 0.5).sin();
        let width = half * half * 2.0;
        let density = e.real(1.0).divide_or_zero(width * TAU);
        Outputs {
            direction: round_axis(e, i.axis, i.u.saturate() * width, i.v),
            density: clamp_finite(density),
        }
    }
}

/// The unit direction with `1 - cos` of its angle to the axis, and a share of the full turn round it.
#[inline(always)]
pub fn round_axis<E: Emit>(
    e: E,
    axis: Vector<E::Real>,
    height: E::Real,
    turn: E::Real,
) -> Vector<E::Real> {
    let axis = axis.normalized();
    let (z, r) = (e.real(1.0) - height, sqrt_or_zero(height * (e.real(2.0) - height)));
    let turn = turn.saturate() * TAU;
    let local = Vector { x: r * turn.cos(), y: r * turn.sin(), z };
    Frame::around(axis).world(local).normalized()
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn it_fills_the_cone_evenly() {
        let axis = [0.0, 0.0, 2.0];
        for angle in [1e-6_f32, 1e-3, 0.5, 2.0, std::f32::consts::PI] {
            let k = 2.0 * (f64::from(angle) / 2.0).sin().powi(2);
            for u in [0.0, 0.25, 0.999_999_94] {
                let to = numbers!(axis = axis, angle = angle, u = u, v = 0.25 => direction);
                let h = k * f64::from(u);
                let sine = (h * (2.0 - h)).sqrt();
                assert_close(&to[1..], &[sine, 1.0 - h], 3e-6, 2e-7 * f64::from(angle));
                assert!(to[0].abs() <= 2e-7 * angle);
            }
            let density = number!(axis = axis, angle = angle => density);
            assert_close(&[density], &[1.0 / (std::f64::consts::TAU * k)], 1e-6, 0.0);
        }
    }

    #[test]
    fn without_width_it_is_the_axis() {
        let axis = [0.6, 0.0, -0.8];
        assert_close(
            &numbers!(axis = axis, angle = 0.0 => direction),
            &axis.map(f64::from),
            2e-7,
            1e-7,
        );
        assert_eq!(number!(axis = axis, angle = 0.0 => density), 0.0);
        assert_eq!(numbers!(axis = [0.0; 3], angle = 0.0 => direction), [0.0; 3]);
    }
}
