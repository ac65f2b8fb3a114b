use crate::emit::Real;

/// Largest number below 1: `x - floor(x)` would round up to 1 for small negative `x`.
const BELOW_ONE: f64 = 1.0 - 1.0 / 16_777_216.0;

node! {
    /// What is left above the next lower integer, per component: `input - floor(input)`, always
    /// below 1. A colour keeps its alpha.
    fraction in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The fraction.
        result: generic, in 0.0..=BELOW_ONE;
    }
    body |e, i| (i.input - i.input.floor()).minimum(e.real(BELOW_ONE))
}

#[cfg(test)]
mod tests {
    #[test]
    fn stays_below_one() {
        assert_eq!(numbers!(input = [1.25, -1.25, 3.0] => result), [0.25, 0.75, 0.0]);
        assert_eq!(number!(input = -1e-10 => result), 1.0_f32.next_down());
        assert_eq!(number!(input = -1e-45 => result), 1.0_f32.next_down());
        assert_eq!(number!(input = 1e30 => result), 0.0);
        assert_eq!(numbers!(input = [1.5, 0.0, -0.5, 1.5] => result), [0.5, 0.0, 0.5, 1.5]);
    }
}
