use crate::emit::functions::conventions::pow_or_zero;

node! {
    /// `base` to a power, per component. Anything to the power 0 is 1; 0 to a negative power, and a
    /// negative base to a power that is not whole, is 0; what overflows is the largest finite number.
    /// A colour keeps its alpha.
    power in arithmetic per component,
    source "",
    inputs {
        /// What is raised.
        base: generic = 1.0, avoid negative;
        /// The power.
        exponent: scalar = 1.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| pow_or_zero(i.base, i.exponent)
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        for (base, exponent, expected) in [
            (2.0, 10.0, 1024.0),
            (2.0, -1.0, 0.5),
            (9.0, 0.5, 3.0),
            (0.03, 0.25, 0.416179145),
            (10.0, -38.0, 1e-38),
            (-2.0, 3.0, -8.0),
            (-2.0, 2.0, 4.0),
            (1.5, 1.0, 1.5),
        ] {
            assert_close(
                &numbers!(base = base, exponent = exponent => result),
                &[expected],
                3e-7,
                0.0,
            );
        }
    }

    #[test]
    fn what_has_no_power_is_zero_and_overflow_is_held() {
        for base in [0.0, -0.0, 1e-45, -3.0, f32::MAX, f32::NAN] {
            assert_eq!(number!(base = base, exponent = 0.0 => result), 1.0, "{base}");
        }
        assert_eq!(number!(base = -5.5, exponent = 0.3 => result), 0.0);
        assert_eq!(number!(base = 0.0, exponent = -1.0 => result), 0.0);
        assert_eq!(number!(base = f32::NAN, exponent = 2.0 => result), 0.0);
        assert_eq!(number!(base = 10.0, exponent = 40.0 => result), f32::MAX);
        assert_eq!(number!(base = -10.0, exponent = 41.0 => result), f32::MIN);
        assert_eq!(number!(base = 10.0, exponent = -60.0 => result), 0.0);
    }
}
