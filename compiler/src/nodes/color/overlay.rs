use crate::emit::{Color, Emit, Mask, Real};
use crate::nodes::{BLACK, NOT_NEGATIVE};

node! {
    /// Overlay: `base (base + 2 layer (1 - base))`, per component; a layer of one half leaves the
    /// base as it is, darker layers darken, brighter ones brighten, and black and white stay. The
    /// layer is clamped to 0..1; a base of 1 or more passes, one of 0 or less gives 0. The result
    /// has the alpha of `base`.
    overlay in color,
    source "the thesis's overlay, I / 255 (I + 2 M / 255 (255 - I)), continued outside 0..1",
    inputs {
        /// The colour so far.
        base: color = BLACK, in NOT_NEGATIVE;
        /// What is laid over it.
        layer: color = [0.5, 0.5, 0.5, 1.0], in NOT_NEGATIVE;
    }
    outputs {
        /// The blend.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let color = Color {
            r: overlay(e, i.base.r, i.layer.r),
            g: overlay(e, i.base.g, i.layer.g),
            b: overlay(e, i.base.b, i.layer.b),
            a: i.base.a,
        };
        Outputs { color }
    }
}

/// One component of the blend.
#[inline(always)]
pub fn overlay<E: Emit>(e: E, base: E::Real, layer: E::Real) -> E::Real {
    let (zero, one) = (e.real(0.0), e.real(1.0));
    let twice = layer.saturate() * 2.0;
    let blended = base * twice.mul_add(one - base, base);
    let not_black = base.greater(zero).select(blended, zero);
    base.greater_equal(one).select(base, not_black)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn overlay(base: f32, layer: f32) -> Vec<f32> {
        numbers!(base = [base, base, base, 0.5], layer = [layer, layer, layer, 1.0] => color)
    }

    #[test]
    fn known_values() {
        for (i, m, expected) in [
            (0.0, 0.7, 0.0),
            (1.0, 0.7, 1.0),
            (0.4, 0.5, 0.4),
            (0.4, 0.0, 0.16),
            (0.4, 1.0, 0.64),
            (0.25, 0.75, 0.34375),
        ] {
            assert_close(&overlay(i, m), &[expected, expected, expected, 0.5], 2e-7, 0.0);
        }
    }

    #[test]
    fn outside_the_unit_interval_it_neither_turns_nor_jumps() {
        for (i, m, expected) in [
            (2.0, 2.0, 2.0),
            (1.5, 4.0, 1.5),
            (0.5, 3.0, 0.75),
            (-1.0, 0.5, 0.0),
            (-0.0, 0.5, 0.0),
            (f32::NAN, 0.5, 0.0),
            (0.5, f32::NAN, 0.25),
        ] {
            assert_eq!(overlay(i, m)[..3], [expected; 3], "{i} under {m}");
        }
        for layer in [0.0, 0.3, 1.0] {
            assert!((overlay(1.0_f32.next_down(), layer)[0] - 1.0).abs() <= 2.0 * f32::EPSILON);
            assert!(overlay(1e-30, layer)[0] <= 2e-30);
        }
    }
}
