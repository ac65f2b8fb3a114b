use crate::emit::functions::monotone::{Stop, monotone};
use crate::emit::functions::passage::mixed;
use crate::emit::{Emit, Mask, Real};
use crate::nodes::finite::FACTOR;

node! {
    /// The passage from one stop to the next: `start` up to `from`, `end` past `to`, and between them by
    /// `interpolation`, in every component, alpha too. A `ramp` is made of these. Linear; smooth, by
    /// `t^2 (3 - 2 t)`; constant, `start` before `to`; or monotone, a cubic that also looks at the stops before and
    /// after, so that passages join without a kink and never go past a value. MaterialX's `ramp_gradient`.
    ///
    /// The slopes of the monotone cubic are Steffen's: at a stop that is a peak it is level; elsewhere
    /// at most twice the smaller of the slopes to both sides. A stop beside that is no farther (`before` not
    /// below `from`, `after` not above `to`) does not count.
    ramp_segment in ramps generic,
    source "Steffen 1990, A Simple Method for Monotonic Interpolation in One Dimension",
    inputs {
        /// Where to look.
        input: scalar = 0.0, in FACTOR;
        /// How it goes from stop to stop.
        interpolation: choice = 0, of ["linear", "smooth", "constant", "monotone"];
        /// Where the passage starts.
        from: scalar = 0.0, in FACTOR;
        /// Where it ends; not above `from`, it is a step there.
        to: scalar = 1.0, in FACTOR;
        /// Value at the start.
        start: generic = 0.0, in FACTOR, when shows(e, i, false);
        /// Value at the end.
        end: generic = 1.0, in FACTOR, when shows(e, i, true);
        /// Where the stop before stands.
        before: scalar = 0.0, in FACTOR, when e.mask(i.interpolation == 3);
        /// Where the stop after stands.
        after: scalar = 1.0, in FACTOR, when e.mask(i.interpolation == 3);
        /// Value of the stop before.
        value_before: generic = 0.0, in FACTOR, when e.mask(i.interpolation == 3);
        /// Value of the stop after.
        value_after: generic = 1.0, in FACTOR, when e.mask(i.interpolation == 3);
    }
    outputs {
        /// The value.
        result: generic, in FACTOR;
    }
    body |e, i| {
        let share = share(e, i);
        let result = match i.interpolation {
            0 => mixed(i.start, i.end, share),
            1 => mixed(i.start, i.end, share * share * (e.real(3.0) - share * 2.0)),
            2 => share.less(e.real(1.0)).select(i.start, i.end),
            _ => cubic(i, share),
        };
        Outputs { result }
    }
}

/// How much of the passage is behind, 0 to 1.
#[inline(always)]
fn share<E: Emit, T: Copy>(e: E, i: &Inputs<E, T>) -> E::Real {
    let length = i.to - i.from;
    let within = (i.input - i.from).divide_or_zero(length).saturate();
    let step = i.input.less(i.to).select(e.real(0.0), e.real(1.0));
    length.greater(e.real(0.0)).select(within, step)
}

/// Whether the value of one end shows.
#[inline(always)]
fn shows<E: Emit, T: Copy>(e: E, i: &Inputs<E, T>, end: bool) -> E::Mask {
    let share = share(e, i);
    let (zero, one) = (e.real(0.0), e.real(1.0));
    match (i.interpolation, end) {
        (0 | 1, false) | (2, false) => share.less(one),
        (0 | 1, true) => share.greater(zero),
        (2, true) => !share.less(one),
        _ => e.mask(true),
    }
}

#[inline(always)]
fn cubic<E: Emit, T: crate::emit::Components<E::Real>>(i: &Inputs<E, T>, share: E::Real) -> T {
    let (before, after) = (i.value_before.to_words(), i.value_after.to_words());
    let (start, end) = (i.start.to_words(), i.end.to_words());
    let mut result = start;
    for k in 0..4 {
        let stops = [
            Stop { at: i.before, value: before[k] },
            Stop { at: i.from, value: start[k] },
            Stop { at: i.to, value: end[k] },
            Stop { at: i.after, value: after[k] },
        ];
        result[k] = monotone(stops, share);
    }
    T::from_words(result)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    fn at(input: f32, interpolation: i32) -> f32 {
        number!(
            input = input, interpolation = interpolation, from = 1.0, to = 3.0, start = -1.0,
            end = 7.0, before = 0.0, after = 4.0, value_before = -2.0, value_after = 6.0 => result
        )
    }

    #[test]
    fn every_way_from_end_to_end() {
        for interpolation in 0..4 {
            for (input, value) in [(-9.0, -1.0), (1.0, -1.0), (3.0, 7.0), (1e9, 7.0)] {
                assert_eq!(at(input, interpolation), value, "{interpolation}");
            }
        }
        assert_eq!([at(1.5, 0), at(2.0, 0), at(2.0, 1)], [1.0, 3.0, 3.0]);
        assert_eq!([at(1.5, 1), at(2.9, 2), at(1.0, 2)], [0.25, -1.0, -1.0]);
    }

    #[test]
    fn monotone_cubics_have_the_slopes_of_steffen() {
        // Left: secants 1 and 4 over 1 and 2, p = (1 * 2 + 4 * 1) / 3 = 2: 2 min(1, 4, 1) = 2.
        // Right: a peak, level. Hermite from -1 to 7 over 2 with slopes 2 and 0.
        for (input, exact) in [(1.5, 0.8125), (2.0, 3.5), (2.5, 5.9375)] {
            assert_close(&[at(input, 3)], &[exact], 1e-6, 0.0);
        }
        // Without stops beside: a straight line.
        let alone = numbers!(
            input = 0.3, interpolation = 3, start = 2.0, end = 4.0, before = 0.0, after = 1.0 => result
        );
        assert_close(&alone, &[2.6], 1e-6, 0.0);
    }

    #[test]
    fn a_passage_of_no_length_is_a_step() {
        let step = |input: f32| number!(input = input, from = 1.0, to = 1.0 => result);
        assert_eq!([step(1.0_f32.next_down()), step(1.0)], [0.0, 1.0]);
        let back = |input: f32| number!(input = input, from = 1.0, to = 0.5 => result);
        assert_eq!([back(0.4), back(0.5)], [0.0, 1.0]);
    }

    #[test]
    fn a_value_that_does_not_show_is_not_asked_for() {
        for interpolation in 0..3 {
            assert!(demanded!(input = -1.0, interpolation = interpolation => start));
            assert!(!demanded!(input = -1.0, interpolation = interpolation => end));
            assert!(!demanded!(input = 2.0, interpolation = interpolation => start));
            assert!(!demanded!(input = 0.5, interpolation = interpolation => before));
        }
        assert!(demanded!(input = 0.5, interpolation = 3 => value_after));
        assert!(!demanded!(input = 0.5, interpolation = 2 => end));
    }
}
