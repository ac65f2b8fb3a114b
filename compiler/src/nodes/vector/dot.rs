use crate::nodes::finite::FACTOR;

node! {
    /// Dot product `a.x b.x + a.y b.y + a.z b.z`: of unit vectors the cosine between them.
    dot in vector,
    source "",
    inputs {
        /// First vector.
        a: vector = [0.0; 3], in FACTOR;
        /// Second vector.
        b: vector = [0.0; 3], in FACTOR;
    }
    outputs {
        /// The product.
        result: scalar;
    }
    body |e, i| Outputs { result: i.a.dot(i.b) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn sums_the_products() {
        assert_eq!(number!(a = [1.0, 2.0, 3.0], b = [4.0, -5.0, 6.0] => result), 12.0);
        assert_eq!(number!(a = [0.0; 3], b = [1e19; 3] => result), 0.0);
        assert!(number!(a = [1e19; 3], b = [1e19; 3] => result).is_finite());
    }

    #[test]
    fn products_are_fused() {
        // (1 + e)(1 - e) - 1 is -e^2, which a rounded product would lose.
        let e = f32::EPSILON;
        let product = number!(a = [1.0 + e, 0.0, -1.0], b = [1.0 - e, 0.0, 1.0] => result);
        assert_eq!(product, -e * e);
    }
}
