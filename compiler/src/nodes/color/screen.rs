use crate::emit::{Color, Emit, Mask, Real};
use crate::nodes::{BLACK, NOT_NEGATIVE};

node! {
    /// Screen: `base + layer - base layer`, per component; white wins over everything, black leaves
    /// the other as it is. The formula turns round for light brighter than 1 (2 over 2 would be
    /// black), so where either reaches 1 the brighter of the two is taken, which meets the formula
    /// there. The result has the alpha of `base`.
    screen in color,
    source "the thesis's screen, 255 - (255 - M)(255 - I) / 255, continued above 1",
    inputs {
        /// The colour so far.
        base: color = BLACK, in NOT_NEGATIVE;
        /// What is laid over it.
        layer: color = BLACK, in NOT_NEGATIVE;
    }
    outputs {
        /// The blend.
        color: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let color = Color {
            r: screen(e, i.base.r, i.layer.r),
            g: screen(e, i.base.g, i.layer.g),
            b: screen(e, i.base.b, i.layer.b),
            a: i.base.a,
        };
        Outputs { color }
    }
}

#[inline(always)]
fn screen<E: Emit>(e: E, a: E::Real, b: E::Real) -> E::Real {
    let one = e.real(1.0);
    let both_below_one = a.less(one) & b.less(one);
    both_below_one.select(b.mul_add(one - a, a), a.maximum(b))
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn screen(base: f32, layer: f32) -> Vec<f32> {
        numbers!(base = [base, base, base, 0.5], layer = [layer, layer, layer, 1.0] => color)
    }

    #[test]
    fn known_values() {
        for (a, b, expected) in [
            (0.0, 0.3, 0.3),
            (1.0, 0.3, 1.0),
            (0.25, 0.5, 0.625),
            (1e-12, 1e-12, 1.999999999999e-12),
            (0.2, 0.6, 0.68),
            (0.5, 0.3, 0.65),
            (0.8, 0.9, 0.98),
        ] {
            assert_close(&screen(a, b), &[expected, expected, expected, 0.5], 2e-7, 0.0);
        }
    }

    #[test]
    fn light_above_one_is_kept() {
        for (a, b, expected) in [
            (2.0, 2.0, 2.0),
            (3.0, 3.0, 3.0),
            (2.0, 0.5, 2.0),
            (0.5, 2.0, 2.0),
            (0.999, 1.001, 1.001),
        ] {
            assert_eq!(screen(a, b)[..3], [expected; 3]);
        }
    }

    #[test]
    fn the_two_forms_meet_at_one() {
        for other in [0.0, 0.3, 0.999, 1.0, 5.0] {
            let (below, at) = (screen(1.0_f32.next_down(), other)[0], screen(1.0, other)[0]);
            assert!((below - at).abs() <= 2.0 * f32::EPSILON, "{below} and {at}");
        }
    }
}
