use crate::emit::functions::figures::{one_where, within_tile};
use crate::emit::{Emit, Real};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Stripes, 1 over the first `width` of each period and 0 over the rest; or waves between 0 and 1: a
    /// sine that starts in its trough, a triangle that does, a saw that rises. Across any number: u, a
    /// coordinate, or a distance, for rings. A little noise added to it makes wood and marble. Blender calls it
    /// Wave.
    stripes in patterns,
    source "",
    inputs {
        /// What the stripes are across.
        input: scalar = state(Field::U), in FACTOR;
        /// Periods per unit.
        frequency: scalar = 8.0, in FACTOR, unit "periods per unit", soft 0.0..=100.0;
        /// What they are moved by, in periods.
        offset: scalar = 0.0, in FACTOR, unit "periods", soft UNIT;
        /// What is between 0 and 1.
        profile: choice = 0, of ["stripes", "sine", "triangle", "saw"];
        /// Share of the period that a stripe covers; of stripes only.
        width: scalar = 0.5, in 0.0..=1.0, when e.mask(i.profile == 0);
    }
    outputs {
        /// From 0 to 1.
        result: scalar, in 0.0..=1.0;
        /// Which period it is: a whole number, 0 for the first from the origin.
        number: scalar;
    }
    body |e, i| {
        let at = i.input * i.frequency - i.offset;
        Outputs { result: wave(e, i, within_tile(at)), number: at.floor() }
    }
}

#[inline(always)]
fn wave<E: Emit>(e: E, i: &Inputs<E>, share: E::Real) -> E::Real {
    match i.profile {
        0 => one_where(e, share.less(i.width)),
        1 => ((share * std::f64::consts::TAU).cos() * -0.5 + 0.5).saturate(),
        2 => e.real(1.0) - (share * 2.0 - 1.0).absolute(),
        _ => share,
    }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn each_profile_goes_round() {
        for (profile, expected) in [
            (0, [1.0, 1.0, 0.0, 0.0]),
            (1, [0.0, 0.5, 1.0, 0.5]),
            (2, [0.0, 0.5, 1.0, 0.5]),
            (3, [0.0, 0.25, 0.5, 0.75]),
        ] {
            for period in [0.0, -3.0, 100.0] {
                let at = |x: f32| number!(input = (period + x) / 4.0, frequency = 4.0, profile = profile => result);
                let found = [at(0.0), at(0.25), at(0.5), at(0.75)];
                assert_close(&found, &expected, 1e-6, 1e-6);
            }
        }
    }

    #[test]
    fn stripes_may_cover_nothing_or_all_and_are_numbered() {
        for x in [0.0, 0.3, 0.999] {
            assert_eq!(number!(input = x, width = 0.0 => result), 0.0);
            assert_eq!(number!(input = x, width = 1.0 => result), 1.0);
        }
        assert_eq!(number!(input = -0.1, frequency = 10.0, offset = 0.5 => number), -2.0);
    }
}
