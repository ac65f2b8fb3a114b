use crate::emit::functions::conventions::sqrt_or_zero;
use crate::nodes::NOT_NEGATIVE;

node! {
    /// Square root, correctly rounded, per component; of a negative value 0. A colour keeps its
    /// alpha.
    square_root in arithmetic per component,
    source "",
    inputs {
        /// Any value.
        input: generic = 0.0;
    }
    outputs {
        /// The root.
        result: generic, in NOT_NEGATIVE;
    }
    body |e, i| sqrt_or_zero(i.input)
}

#[cfg(test)]
mod tests {
    #[test]
    fn negative_values_have_root_zero() {
        assert_eq!(numbers!(input = [4.0, -1.5, 0.25] => result), [2.0, 0.0, 0.5]);
        assert_eq!(number!(input = -0.0 => result).to_bits(), 0);
        assert_eq!(number!(input = 1e-45 => result), 1e-45_f32.sqrt());
        assert_eq!(numbers!(input = [4.0, 9.0, 16.0, 0.25] => result), [2.0, 3.0, 4.0, 0.25]);
    }
}
