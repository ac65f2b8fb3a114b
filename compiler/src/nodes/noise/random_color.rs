use crate::emit::functions::cells::share_of;
use crate::emit::functions::colors::from_hsv;
use crate::emit::{Emit, Real};
use crate::nodes::finite::UNIT;

node! {
    /// A random colour for a number, the same at every look, its hue, saturation and value each evenly
    /// between two bounds. MaterialX's `randomcolor` has the same values; see `random_scalar`.
    random_color in noise,
    source "Jenkins 2006, lookup3; MaterialX 1.39, randomcolor",
    inputs {
        /// What the colour is of.
        input: scalar = 0.0;
        /// Least hue.
        hue_low: scalar = 0.0, in -100.0..=100.0, unit "turns", soft UNIT;
        /// Most hue.
        hue_high: scalar = 1.0, in -100.0..=100.0, unit "turns", soft UNIT;
        /// Least saturation; below 0 counts as 0.
        saturation_low: scalar = 0.825, in -100.0..=100.0, soft UNIT;
        /// Most saturation.
        saturation_high: scalar = 1.0, in -100.0..=100.0, soft UNIT;
        /// Least value, the brightest component.
        value_low: scalar = 1.0, in -1e9..=1e9, soft UNIT;
        /// Most value.
        value_high: scalar = 1.0, in -1e9..=1e9, soft UNIT;
        /// Another seed gives other colours.
        seed: integer = 0;
    }
    outputs {
        /// The colour.
        color: color;
    }
    body |e, i| {
        let hue = between(e, share_of(i.input, i.seed + e.int(414)), i.hue_low, i.hue_high);
        let saturation = share_of(i.input, i.seed + e.int(1523));
        let saturation = between(e, saturation, i.saturation_low, i.saturation_high);
        let value = between(e, share_of(i.input, i.seed + e.int(1814)), i.value_low, i.value_high);
        Outputs { color: from_hsv([hue, saturation.maximum(e.real(0.0)), value], e.real(1.0)) }
    }
}

/// From `low` at 0 to `high` at 1.
#[inline(always)]
fn between<E: Emit>(e: E, share: E::Real, low: E::Real, high: E::Real) -> E::Real {
    share.mul_add(high, (e.real(1.0) - share) * low)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn a_value_of_materialx() {
        let color = numbers!(
            input = 1.0, hue_low = 0.704281, hue_high = 0.646463, saturation_low = -1.77234,
            saturation_high = 1.05181, value_low = 0.276518, value_high = 2.10626, seed = 5 => color
        );
        assert_close(&color, &[0.21862413, 0.14137809, 1.75471365, 1.0], 2e-5, 0.0);
        let grey = numbers!(
            input = -2.40445, hue_low = -2.28679, hue_high = -0.438242, saturation_low = -2.09732,
            saturation_high = 0.869872, value_low = 2.88134, value_high = -0.265634, seed = 2 => color
        );
        assert_close(&grey, &[0.565304041, 0.565304041, 0.565304041, 1.0], 1e-5, 0.0);
    }

    #[test]
    fn bounds_that_are_equal_give_one_colour() {
        for input in [0.0, 1.0, 2.5] {
            let color = numbers!(
                input = input, hue_low = 0.0, hue_high = 0.0, saturation_low = 1.0 => color
            );
            assert_close(&color, &[1.0, 0.0, 0.0, 1.0], 1e-6, 1e-6);
        }
    }
}
