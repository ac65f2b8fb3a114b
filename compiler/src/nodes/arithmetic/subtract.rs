use crate::nodes::finite::SUMMAND;

node! {
    /// Difference `a - b`, per component. A colour keeps the alpha of `a`.
    subtract in arithmetic per component,
    source "",
    inputs {
        /// What is subtracted from.
        a: generic = 0.0, in SUMMAND;
        /// What is subtracted.
        b: generic = 0.0, in SUMMAND;
    }
    outputs {
        /// The difference.
        result: generic;
    }
    body |e, i| i.a - i.b
}

#[cfg(test)]
mod tests {
    #[test]
    fn subtracts_down_to_subnormals() {
        let (a, b) = (f32::from_bits(0x0080_0001), f32::MIN_POSITIVE);
        assert_eq!(number!(a = a, b = b => result).to_bits(), 1);
        assert_eq!(
            numbers!(a = [1.0, 2.0, 3.0, 0.5], b = [1.0, 1.0, 4.0, 9.0] => result),
            [0.0, 1.0, -1.0, 0.5]
        );
    }
}
