use crate::emit::functions::rotation::diagonal;

node! {
    /// The transform that stretches along the axes.
    scaling in transforms,
    source "",
    inputs {
        /// Factor along each axis.
        factor: vector = [1.0; 3];
    }
    outputs {
        /// The transform.
        transform: transform;
    }
    body |e, i| Outputs { transform: diagonal(e, i.factor.x, i.factor.y, i.factor.z) }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_factors_are_the_diagonal() {
        let rows = numbers!(factor = [2.0, 3.0, 4.0] => transform);
        let expected =
            [2.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        assert_eq!(rows, expected);
    }
}
