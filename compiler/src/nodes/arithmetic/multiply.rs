use crate::nodes::finite::FACTOR;

node! {
    /// Product `a b`, per component. A colour keeps the alpha of `a`.
    multiply in arithmetic per component,
    source "",
    inputs {
        /// First factor.
        a: generic = 1.0, in FACTOR;
        /// Second factor.
        b: generic = 1.0, in FACTOR;
    }
    outputs {
        /// The product.
        result: generic;
    }
    body |e, i| i.a * i.b
}

#[cfg(test)]
mod tests {
    #[test]
    fn multiplies_and_underflows_gradually() {
        assert_eq!(number!(a = 1e-30, b = 1e-10 => result), 1e-40);
        assert_eq!(
            numbers!(a = [0.5, 2.0, -3.0, 0.5], b = [0.5, 0.25, 2.0, 0.0] => result),
            [0.25, 0.5, -6.0, 0.5]
        );
    }
}
