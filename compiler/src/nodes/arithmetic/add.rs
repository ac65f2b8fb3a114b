use crate::nodes::finite::SUMMAND;

node! {
    /// Sum `a + b`, per component. A colour keeps the alpha of `a`.
    add in arithmetic per component,
    source "",
    inputs {
        /// First summand.
        a: generic = 0.0, in SUMMAND;
        /// Second summand.
        b: generic = 0.0, in SUMMAND;
    }
    outputs {
        /// The sum.
        result: generic;
    }
    body |e, i| i.a + i.b
}

#[cfg(test)]
mod tests {
    #[test]
    fn adds() {
        assert_eq!(number!(a = 0.1, b = 0.2 => result), 0.1_f32 + 0.2);
        assert_eq!(numbers!(a = [1.0, 2.0, -3.0], b = [0.5, 0.5, 3.0] => result), [1.5, 2.5, 0.0]);
    }

    #[test]
    fn keeps_the_sign_of_zero() {
        assert_eq!(number!(a = -0.0, b = -0.0 => result).to_bits(), (-0.0_f32).to_bits());
        assert_eq!(number!(a = -0.0, b = 0.0 => result).to_bits(), 0.0_f32.to_bits());
    }
}
