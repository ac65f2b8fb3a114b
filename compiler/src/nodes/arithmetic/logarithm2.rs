use crate::emit::functions::conventions::log2_or_zero;

node! {
    /// Logarithm to base 2, per component; 0 for what has none: zero and negative values. A
    /// colour keeps its alpha.
    logarithm2 in arithmetic per component,
    source "",
    inputs {
        /// Any value above zero.
        input: generic = 0.0;
    }
    outputs {
        /// The value.
        result: generic;
    }
    body |e, i| log2_or_zero(i.input)
}

#[cfg(test)]
mod tests {
    #[test]
    fn whole_powers_are_exact() {
        for (x, log) in [(1.0, 0.0), (1024.0, 10.0), (0.25, -2.0), (0.0, 0.0), (-1.0, 0.0)] {
            assert_eq!(number!(input = x => result), log);
        }
    }
}
