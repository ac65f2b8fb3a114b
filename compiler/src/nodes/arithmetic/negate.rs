node! {
    /// The same magnitude with the other sign, per component. A colour keeps its alpha.
    negate in arithmetic per component,
    source "",
    inputs {
        /// What is negated.
        input: generic = 0.0;
    }
    outputs {
        /// `-input`.
        result: generic;
    }
    body |e, i| -i.input
}

#[cfg(test)]
mod tests {
    #[test]
    fn flips_the_sign_bit() {
        assert_eq!(number!(input = 0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(numbers!(input = [1.0, -2.0, 1e-45] => result), [-1.0, 2.0, -1e-45]);
        assert_eq!(numbers!(input = [1.0, -2.0, 3.0, 0.5] => result), [-1.0, 2.0, -3.0, 0.5]);
    }
}
