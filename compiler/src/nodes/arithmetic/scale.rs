use crate::nodes::finite::FACTOR;

node! {
    /// Product of every component with one number. A colour keeps its alpha.
    scale in arithmetic per component,
    source "",
    inputs {
        /// What is scaled.
        input: generic = 1.0, in FACTOR;
        /// By how much.
        factor: scalar = 1.0, in FACTOR;
    }
    outputs {
        /// The product.
        result: generic;
    }
    body |e, i| i.input * i.factor
}

#[cfg(test)]
mod tests {
    #[test]
    fn scales() {
        assert_eq!(number!(input = 3.0, factor = -0.5 => result), -1.5);
        assert_eq!(numbers!(input = [1.0, 2.0, 3.0], factor = 2.0 => result), [2.0, 4.0, 6.0]);
        assert_eq!(number!(input = -1.0, factor = 0.0 => result).to_bits(), (-0.0_f32).to_bits());
    }
}
