use crate::emit::Real;
use crate::emit::functions::conventions::{clamp_finite, log2_or_zero};

node! {
    /// Logarithm to any base, per component: `log2(input) / log2(base)`. 0 where either has
    /// none, and for base 1. A colour keeps its alpha.
    logarithm_to_base in arithmetic per component,
    source "",
    inputs {
        /// Any value above zero.
        input: generic = 1.0;
        /// The base.
        base: scalar = 2.0, avoid negative;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| clamp_finite(log2_or_zero(i.input).divide_or_zero(log2_or_zero(i.base)))
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_exponent() {
        assert_eq!(number!(input = 8.0, base = 2.0 => result), 3.0);
        assert_eq!(number!(input = 8.0, base = 0.5 => result), -3.0);
        for base in [0.0, 1.0, -2.0] {
            assert_eq!(number!(input = 8.0, base = base => result), 0.0);
        }
        let error = number!(input = 81.0, base = 3.0 => result) - 4.0;
        assert!(error.abs() < 2e-6);
    }
}
