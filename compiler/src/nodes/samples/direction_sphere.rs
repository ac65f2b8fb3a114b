use crate::emit::{Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::samples::direction_cone::round_axis;
use crate::nodes::state;
use crate::state::Field;

node! {
    /// A direction of the whole sphere, evenly spread: its height is `1 - 2 u`, and v turns it round z. As a
    /// point it lies on the unit sphere.
    direction_sphere in samples,
    source "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th ed., A.5.2",
    inputs {
        /// First number drawn, 0 to 1.
        u: scalar = state(Field::SampleU), in UNIT;
        /// Second number drawn, 0 to 1.
        v: scalar = state(Field::SampleV), in UNIT;
    }
    outputs {
        /// The direction, unit length.
        direction: vector, in -1.0..=1.0;
    }
    body |e, i| {
        let up = Vector { x: e.real(0.0), y: e.real(0.0), z: e.real(1.0) };
        Outputs { direction: round_axis(e, up, i.u.saturate() * 2.0, i.v) }
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn heights_are_even_and_both_poles_are_reached() {
        for (u, v, expected) in [
            (0.0, 0.3, [0.0, 0.0, 1.0]),
            (1.0, 0.3, [0.0, 0.0, -1.0]),
            (0.5, 0.0, [1.0, 0.0, 0.0]),
            (0.5, 0.25, [0.0, 1.0, 0.0]),
            (0.25, 0.5, [-0.75_f64.sqrt(), 0.0, 0.5]),
        ] {
            assert_close(&numbers!(u = u, v = v => direction), &expected, 1e-6, 3e-7);
        }
    }
}
