use crate::nodes::finite::FACTOR;

node! {
    /// Cross product: perpendicular to both, as long as the area they span, right-handed.
    cross in vector,
    source "",
    inputs {
        /// First vector.
        a: vector = [0.0; 3], in FACTOR;
        /// Second vector.
        b: vector = [0.0; 3], in FACTOR;
    }
    outputs {
        /// The product.
        result: vector;
    }
    body |e, i| Outputs { result: i.a.cross(i.b) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn is_right_handed() {
        assert_eq!(numbers!(a = [1.0, 0.0, 0.0], b = [0.0, 1.0, 0.0] => result), [0.0, 0.0, 1.0]);
        assert_eq!(numbers!(a = [1.0, 2.0, 3.0], b = [4.0, 5.0, 6.0] => result), [-3.0, 6.0, -3.0]);
        assert_eq!(numbers!(a = [2.0, 4.0, 6.0], b = [1.0, 2.0, 3.0] => result), [0.0; 3]);
        assert_eq!(numbers!(a = [0.0; 3], b = [1.0, 2.0, 3.0] => result), [0.0; 3]);
    }
}
