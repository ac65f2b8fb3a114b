use crate::nodes::NOT_NEGATIVE;
use crate::nodes::finite::SUMMAND;

node! {
    /// Euclidean length. The largest component is divided out first, so that squares neither
    /// overflow nor vanish.
    length in vector,
    source "",
    inputs {
        /// Any vector.
        input: vector = [0.0; 3], in SUMMAND;
    }
    outputs {
        /// Its length.
        result: scalar, in NOT_NEGATIVE;
    }
    body |e, i| Outputs { result: i.input.length() }
}

#[cfg(test)]
mod tests {
    use crate::nodes::harness::assert_close;

    #[test]
    fn squares_neither_overflow_nor_vanish() {
        assert_close(&numbers!(input = [3.0, 4.0, 12.0] => result), &[13.0], 2e-7, 0.0);
        assert_close(&numbers!(input = [3e30, 4e30, 0.0] => result), &[5e30], 2e-7, 0.0);
        assert_close(&numbers!(input = [3e-30, 4e-30, 0.0] => result), &[5e-30], 2e-7, 0.0);
        assert_eq!(number!(input = [0.0; 3] => result), 0.0);
        assert_eq!(number!(input = [0.0, -1e-45, 0.0] => result), 1e-45);
    }
}
