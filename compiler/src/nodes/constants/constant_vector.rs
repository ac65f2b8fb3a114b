node! {
    /// A vector, given once and used in many places.
    constant_vector in constants,
    source "",
    inputs {
        /// The value.
        value: vector = [0.0; 3];
    }
    outputs {
        /// The same value.
        value: vector;
    }
    body |e, i| Outputs { value: i.value }
}

#[cfg(test)]
mod tests {
    #[test]
    fn passes_its_value() {
        assert_eq!(numbers!(value = [0.1, 2.0, -3.0] => value), [0.1, 2.0, -3.0]);
    }
}
