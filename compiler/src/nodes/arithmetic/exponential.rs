use crate::emit::Real;
use crate::emit::functions::conventions::clamp_finite;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// `e` to the power of the value, per component; what overflows is the largest finite number. A
    /// colour keeps its alpha.
    exponential in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| clamp_finite(i.input.exp())
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn known_values() {
        for (input, expected) in [
            (0.0, 1.0),
            (1.0, std::f64::consts::E),
            (-1.0, 1.0 / std::f64::consts::E),
            (1e-8, 1.0),
            (80.0, 80.0_f64.exp()),
            (-80.0, (-80.0_f64).exp()),
        ] {
            assert_close(&numbers!(input = input => result), &[expected], 3e-7, 0.0);
        }
    }

    #[test]
    fn overflow_is_held_and_underflow_is_gradual() {
        assert_eq!(number!(input = 100.0 => result), f32::MAX);
        assert_eq!(number!(input = f32::MAX => result), f32::MAX);
        assert_eq!(number!(input = f32::MIN => result), 0.0);
        let subnormal = number!(input = -100.0 => result);
        assert!(subnormal > 0.0 && subnormal < f32::MIN_POSITIVE);
        assert_eq!(number!(input = -0.0 => result), 1.0);
    }
}
