use crate::emit::functions::conventions::log2_or_zero;

node! {
    /// Logarithm to base 10, per component; 0 for what has none: zero and negative values. A
    /// colour keeps its alpha.
    logarithm10 in arithmetic per component,
    source "",
    inputs {
        /// Any value above zero.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| log2_or_zero(i.input) * std::f64::consts::LOG10_2
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_that_of_the_definition() {
        let close = crate::nodes::harness::assert_close;
        for x in [1e-40_f32, 0.001, 1.0, 2.0, 1e30] {
            close(&[number!(input = x => result)], &[f64::from(x).log10()], 4e-7, 0.0);
        }
        assert_eq!(number!(input = 0.0 => result), 0.0);
    }
}
