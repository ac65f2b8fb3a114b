use crate::emit::Real;

node! {
    /// The nearest value between two bounds, per component. Where the bounds are crossed, the upper
    /// one holds. NaN becomes the lower bound. A colour keeps its alpha.
    clamp in arithmetic per component,
    source "",
    inputs {
        /// What is clamped.
        input: generic = 0.0;
        /// Lower bound.
        low: generic = 0.0;
        /// Upper bound.
        high: generic = 1.0;
    }
    outputs {
        /// The value between the bounds.
        result: generic;
    }
    body |e, i| i.input.clamp_to(i.low, i.high)
}

#[cfg(test)]
mod tests {
    #[test]
    fn clamps_to_the_unit_interval_unasked() {
        for (given, expected) in [(-1.0, 0.0), (0.25, 0.25), (7.0, 1.0), (f32::NAN, 0.0)] {
            assert_eq!(number!(input = given => result), expected);
        }
        let below_one = 1.0_f32.next_down();
        assert_eq!(number!(input = below_one => result), below_one);
    }

    #[test]
    fn crossed_bounds_give_the_upper() {
        assert_eq!(number!(input = 5.0, low = 3.0, high = 2.0 => result), 2.0);
        assert_eq!(number!(input = 0.0, low = 3.0, high = 2.0 => result), 2.0);
    }
}
