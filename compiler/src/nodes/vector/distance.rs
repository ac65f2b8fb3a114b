use crate::nodes::NOT_NEGATIVE;
use crate::nodes::finite::FACTOR;

node! {
    /// Distance of two points: the length of their difference. The largest component is divided
    /// out first, so that squares neither overflow nor vanish.
    distance in vector,
    source "",
    inputs {
        /// First point.
        a: vector = [0.0; 3], in FACTOR;
        /// Second point.
        b: vector = [0.0; 3], in FACTOR;
    }
    outputs {
        /// The distance.
        result: scalar, in NOT_NEGATIVE;
    }
    body |e, i| Outputs { result: (i.a - i.b).length() }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_the_length_of_the_difference() {
        assert_eq!(number!(a = [1.0, 2.0, 3.0], b = [1.0, 5.0, 7.0] => result), 5.0);
        assert_eq!(number!(a = [1e-30, 0.0, 0.0], b = [0.0; 3] => result), 1e-30);
        assert_eq!(number!(a = [7.0; 3], b = [7.0; 3] => result), 0.0);
    }
}
