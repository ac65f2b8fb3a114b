use crate::emit::{Mask, Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A point of the unit disc in the plane z = 0, evenly spread over its area. Squares round the middle of
    /// the unit square become circles, so that samples near one another stay so: with `a = 2 u - 1` and
    /// `b = 2 v - 1`, the larger in magnitude is the radius, and the angle is `pi / 4` times their ratio.
    point_on_disc in samples,
    source "Shirley and Chiu 1997, A Low Distortion Map Between Disk and Square",
    inputs {
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// The point; its z is 0.
        point: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let (a, b) = (i.u.saturate() * 2.0 - 1.0, i.v.saturate() * 2.0 - 1.0);
        let wide = a.absolute().greater(b.absolute());
        let (radius, other) = (wide.select(a, b), wide.select(b, a));
        let angle = other.divide_or_zero(radius) * std::f64::consts::FRAC_PI_4;
        let (near, far) = (radius * angle.cos(), radius * angle.sin());
        let limited = |x: E::Real| x.clamp_to(e.real(-1.0), e.real(1.0));
        Outputs {
            point: Vector {
                x: limited(wide.select(near, far)),
                y: limited(wide.select(far, near)),
                z: e.real(0.0),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn edges_of_the_square_become_the_circle() {
        for (u, v, x, y) in [
            (1.0, 0.5, 1.0, 0.0),
            (0.5, 0.0, 0.0, -1.0),
            (0.5, 0.5, 0.0, 0.0),
            (0.75, 0.5, 0.5, 0.0),
        ] {
            assert_eq!(numbers!(u = u, v = v => point), [x, y, 0.0]);
        }
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert_close(&numbers!(u = 1.0, v = 1.0 => point), &[half, half, 0.0], 2e-7, 0.0);
        assert_close(&numbers!(u = 0.0, v = 1.0 => point), &[-half, half, 0.0], 2e-7, 0.0);
    }

    #[test]
    fn areas_are_kept() {
        // Of the inner square of half the side a quarter of all, and of the disc the same.
        let mut inside = 0;
        for at in 0..4096 {
            let (u, v) = ((at % 64) as f32 / 64.0 + 0.0078, (at / 64) as f32 / 64.0 + 0.0078);
            let point = numbers!(u = u, v = v => point);
            inside += usize::from(point[0].hypot(point[1]) < 0.5);
        }
        assert_eq!(inside, 1024);
    }
}
