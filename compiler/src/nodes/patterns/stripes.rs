use crate::emit::functions::figures::{one_where, spread, within_tile};
use crate::emit::{Emit, Mask, Real};
use crate::nodes::finite::{FACTOR, UNIT};
use crate::nodes::state;
use crate::state::Field;

node! {
    /// Stripes, 1 over the first `width` of each period and 0 over the rest; or waves between 0 and 1: a
    /// sine that starts in its trough, a triangle that does, a saw that rises. Across any number: u, a
    /// coordinate, or a distance, for rings. A little noise added to it makes wood and marble. Blender calls it
    /// Wave.
    ///
    /// With the filter `footprint` it is the mean over what a pixel covers, in closed form, so that stripes
    /// finer than pixels do not flicker but fade to the mean of a period. The mean is that over
    /// `sqrt(input_dx² + input_dy²) frequency` periods.
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
        /// Whether periods shorter than a pixel become their mean.
        filter: choice = 0, of ["none", "footprint"];
        /// Change of the input along the longer axis of the footprint.
        input_dx: scalar = state(Field::DuDx), in FACTOR, when e.mask(i.filter == FOOTPRINT), slope ("shifted_x", "input");
        /// Change of the input along the shorter axis of the footprint.
        input_dy: scalar = state(Field::DuDy), in FACTOR, when e.mask(i.filter == FOOTPRINT), slope ("shifted_y", "input");
    }
    outputs {
        /// From 0 to 1.
        result: scalar, in 0.0..=1.0;
        /// Which period it is: a whole number, 0 for the first from the origin.
        number: scalar;
    }
    body |e, i| {
        let at = i.input * i.frequency - i.offset;
        let result = match i.filter {
            FOOTPRINT => mean(e, i, at),
            _ => wave(e, i, within_tile(at)),
        };
        Outputs { result, number: at.floor() }
    }
}

/// Number of the filter `footprint`.
const FOOTPRINT: i32 = 1;

#[inline(always)]
fn wave<E: Emit>(e: E, i: &Inputs<E>, share: E::Real) -> E::Real {
    match i.profile {
        0 => one_where(e, share.less(i.width)),
        1 => ((share * std::f64::consts::TAU).cos() * -0.5 + 0.5).saturate(),
        2 => e.real(1.0) - (share * 2.0 - 1.0).absolute(),
        _ => share,
    }
}

/// The mean over the footprint: whole periods of it have one mean, and what is left is less than a period.
#[inline(always)]
fn mean<E: Emit>(e: E, i: &Inputs<E>, at: E::Real) -> E::Real {
    let wide = spread(i.input_dx, i.input_dy) * i.frequency.absolute();
    let whole = wide.floor();
    let rest = (wide - whole).saturate();
    let over_rest = mean_of_rest(e, i, within_tile(at - whole * 0.5), rest);
    let of_period = if i.profile == 0 { i.width } else { e.real(0.5) };
    // Divided first: a product of wide numbers may have no 32 bits.
    let share = rest.divide_or_zero(wide);
    let all = (e.real(1.0) - share) * of_period + over_rest * share;
    whole.equal(e.real(0.0)).select(over_rest, all).saturate()
}

/// The mean over `wide`, at most a period, round a place within one. Not as a difference of two integrals, of
/// which little is left where it is narrow: as the value in the middle, and what jumps and bends within reach
/// change it by.
#[inline(always)]
fn mean_of_rest<E: Emit>(e: E, i: &Inputs<E>, share: E::Real, wide: E::Real) -> E::Real {
    let half = wide * 0.5;
    let (zero, one) = (e.real(0.0), e.real(1.0));
    match i.profile {
        0 => {
            let mut covered = zero;
            for period in [-1.0, 0.0, 1.0] {
                // The edges of the stripe from the middle of the footprint.
                let from = (e.real(period) - share).maximum(-half);
                let to = (e.real(period) - share + i.width).minimum(half);
                covered = covered + (to - from).maximum(zero);
            }
            let mean = covered.divide_or_zero(wide);
            wide.greater(zero).select(mean, one_where(e, share.less(i.width)))
        }
        1 => {
            let angle = wide * std::f64::consts::PI;
            let left = angle.greater(zero).select(angle.sin().divide_or_zero(angle), one);
            (share * std::f64::consts::TAU).cos() * left * -0.5 + 0.5
        }
        2 => {
            // Bends at the ends and in the middle, each a change of slope by 4.
            let mut mean = one - (share * 2.0 - 1.0).absolute();
            for (place, bend) in [(0.0, 2.0), (0.5, -2.0), (1.0, 2.0)] {
                let reach = (half - (share - place).absolute()).maximum(zero);
                mean = mean + reach * reach.divide_or_zero(wide) * bend;
            }
            mean
        }
        _ => {
            let (before, after) =
                ((half - share).maximum(zero), (share + half - 1.0).maximum(zero));
            share + (before - after).divide_or_zero(wide)
        }
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

    #[test]
    fn filtered_it_is_the_mean_over_the_footprint() {
        let filtered = |at: f32, wide: f32, profile: i32| {
            number!(
                input = at * 0.5, frequency = 2.0, profile = profile, width = 0.3, filter = 1,
                input_dx = wide * 0.3, input_dy = wide * -0.4 => result
            )
        };
        let raw = |at: f32, profile: i32| number!(input = at, frequency = 1.0, profile = profile, width = 0.3 => result);
        let counted = |at: f32, wide: f32, profile: i32| {
            let places = (0..4000).map(|k| at + wide * ((k as f32 + 0.5) / 4000.0 - 0.5));
            places.map(|at| raw(at, profile)).sum::<f32>() / 4000.0
        };
        for profile in 0..4 {
            for at in [0.1, 0.31, 0.52, 0.97, -3.02, 7.5] {
                assert_close(
                    &[filtered(at, 0.0, profile)],
                    &[f64::from(raw(at, profile))],
                    1e-6,
                    1e-6,
                );
                assert_close(
                    &[filtered(at, 1e-4, profile)],
                    &[f64::from(raw(at, profile))],
                    1e-4,
                    1e-4,
                );
                for wide in [0.05, 0.4, 0.99, 1.0, 1.6, 2.5, 7.3] {
                    let expected = counted(at, wide, profile);
                    assert_close(
                        &[filtered(at, wide, profile)],
                        &[f64::from(expected)],
                        2e-3,
                        2e-3,
                    );
                }
                let mean = if profile == 0 { 0.3 } else { 0.5 };
                assert_close(&[filtered(at, 1e6, profile)], &[mean], 1e-5, 1e-5);
            }
        }
    }
}
