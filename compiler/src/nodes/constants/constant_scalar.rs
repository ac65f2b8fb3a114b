node! {
    /// A number, given once and used in many places.
    constant_scalar in constants,
    source "",
    inputs {
        /// The value.
        value: scalar = 0.0;
    }
    outputs {
        /// The same value.
        value: scalar;
    }
    body |e, i| Outputs { value: i.value }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_its_value() {
        for value in [0.0, -0.0, 1.5, 1e-45, f32::MAX, f32::INFINITY] {
            assert_eq!(number!(value = value => value).to_bits(), value.to_bits());
        }
    }
}
